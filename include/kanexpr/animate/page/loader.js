// Unpacks and runs the script of the page, which is stored compressed.
import { inflateSync, strFromU8 } from 'fflate';

const letters = atob(document.getElementById('viewer').textContent);
const script = document.createElement('script');
script.textContent = strFromU8(inflateSync(Uint8Array.from(letters, (letter) => letter.charCodeAt(0))));
document.body.append(script);
