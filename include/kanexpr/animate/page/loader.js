// Unpacks and runs the script of the page, which is stored compressed.
import { inflateSync, strFromU8 } from 'fflate';
import { bytesOf } from './base64.js';

const script = document.createElement('script');
script.textContent = strFromU8(inflateSync(bytesOf(document.getElementById('viewer').textContent)));
document.body.append(script);
