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

/// The text of the link that was opened: nothing without one, and null if it is damaged.
export function linked() {
  const letters = location.hash.slice(1).replaceAll('-', '+').replaceAll('_', '/');
  if (!letters) return '';
  try {
    const text = strFromU8(inflateSync(strToU8(atob(letters), true)));
    return text === '' || text.includes('\ufffd') ? null : text;
  } catch {
    return null;
  }
}

/// The text of the last visit.
export function remembered() {
  try { return localStorage.getItem(place) ?? ''; } catch { return ''; /* the browser keeps nothing for this page */ }
}

export function keep(text) {
  try { localStorage.setItem(place, text); } catch { /* the browser keeps nothing for this page */ }
}
