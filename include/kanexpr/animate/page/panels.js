// The panels, which the buttons at the right of the player open and close.
const buttons = [...document.querySelectorAll('[aria-controls]')];
const panelOf = (button) => document.getElementById(button.getAttribute('aria-controls'));
const isOverPicture = (button) => panelOf(button).classList.contains('panel');
const onPhone = window.matchMedia('(width < 640px)');

function set(button, isOpen) {
  panelOf(button).hidden = !isOpen;
  button.setAttribute('aria-expanded', isOpen);
}

/// One panel at a time is over the picture; on a phone there is space for only one panel.
export function open(button) {
  for (const other of buttons)
    if (other !== button && (onPhone.matches || (isOverPicture(other) && isOverPicture(button)))) set(other, false);
  set(button, true);
}

/// `changed` is called when a panel opens.
export function panels(changed) {
  for (const button of buttons)
    button.addEventListener('click', () => {
      if (panelOf(button).hidden) open(button);
      else set(button, false);
      changed();
    });
}

export function openPanel(id) {
  open(buttons.find((button) => button.getAttribute('aria-controls') === id));
}
