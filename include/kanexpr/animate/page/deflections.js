// The slider that magnifies the deformations of flexible bodies.
import { deflections } from './motion.js';

/// The slider is hidden if no shape of the runs is deformed.
export function deflectionSlider(runs, changed) {
  const slider = document.getElementById('deflections');
  const factor = document.getElementById('deflection-factor');
  document.getElementById('deflection-size').hidden = !runs.some((run) => run.bends);
  const scale = () => {
    deflections.factor = 10 ** slider.valueAsNumber;
    factor.value = `× ${Number(deflections.factor.toPrecision(2))}`;
    slider.setAttribute('aria-valuetext', factor.value);
  };
  slider.addEventListener('input', () => {
    scale();
    changed();
  });
  scale();
}
