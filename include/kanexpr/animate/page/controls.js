// The buttons, keys and time below the picture.
const element = (id) => document.getElementById(id);

const icons = { play: 'M8 5v14l11-7z', pause: 'M7 5h4v14H7zM13 5h4v14h-4z' };

/// The number of decimals that resolve a thousandth of the duration.
function digitsFor(duration) {
  return duration > 0 ? Math.max(1, Math.min(9, 3 - Math.floor(Math.log10(duration) + 0.5))) : 1;
}

export function controls(player, camera) {
  const range = element('time');
  const digits = digitsFor(player.last - player.first);
  range.min = player.first;
  range.max = player.last;

  element('play').addEventListener('click', () => player.toggle());
  range.addEventListener('input', () => player.seek(range.valueAsNumber));
  element('speed').addEventListener('change', (event) => (player.speed = Number(event.target.value)));
  element('loop').addEventListener('click', () => loop(player));
  element('follow').checked = camera.follows;
  element('follow').addEventListener('change', (event) => (camera.follows = event.target.checked));
  element('home').addEventListener('click', () => camera.home());
  document.addEventListener('keydown', (event) => press(event, player));

  return function show() {
    const time = player.time.toFixed(digits);
    range.value = player.time;
    range.setAttribute('aria-valuetext', `${time} seconds`);
    element('clock').textContent = `${time} / ${player.last.toFixed(digits)} s`;
    element('play').setAttribute('aria-label', player.playing ? 'Pause' : 'Play');
    element('play-icon').setAttribute('d', player.playing ? icons.pause : icons.play);
  };
}

function loop(player) {
  player.loops = !player.loops;
  element('loop').setAttribute('aria-pressed', player.loops);
}

function press(event, player) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName === 'SELECT') return;
  const step = ((player.last - player.first) / 100) * (event.shiftKey ? 10 : 1);
  const pressed = event.target.tagName === 'BUTTON' || event.target.type === 'checkbox';
  const slides = event.target.type === 'range' && event.target.id !== 'time';
  const acts = {
    ' ': () => player.toggle(),
    l: () => loop(player),
    ArrowLeft: () => player.seek(player.time - step),
    ArrowRight: () => player.seek(player.time + step),
    Home: () => player.seek(player.first),
    End: () => player.seek(player.last),
  };
  if (!(event.key in acts) || (event.key === ' ' && pressed) || (event.key.length > 1 && slides)) return;
  event.preventDefault();
  acts[event.key]();
}
