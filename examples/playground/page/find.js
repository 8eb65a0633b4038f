/// The element with this id.
export const find = (id) => document.getElementById(id);
