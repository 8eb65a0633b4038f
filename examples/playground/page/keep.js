// The text outlives the page: in its address, as a link to share, and in the browser's memory.
import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';

const place = 'kanexpr playground';

/// A link to this page with the text.
export function linkTo(text) {
  const letters = btoa(strFromU8(deflateSync(strToU8(text), { level: 9 }), true));
  const address = new URL(location.href);
  address.hash = letters.replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
  return address.href;
}

function linked() {
  try {
    const letters = location.hash.slice(1).replaceAll('-', '+').replaceAll('_', '/');
    return letters && strFromU8(inflateSync(strToU8(atob(letters), true)));
  } catch {
    return '';
  }
}

/// The text of the link that was opened, or the one of the last visit.
export function kept() {
  let remembered = '';
  try { remembered = localStorage.getItem(place) ?? ''; } catch { /* the browser keeps nothing for this page */ }
  return linked() || remembered;
}

export function keep(text) {
  try { localStorage.setItem(place, text); } catch { /* the browser keeps nothing for this page */ }
}
