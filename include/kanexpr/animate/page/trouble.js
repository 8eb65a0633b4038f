// A message that is shown instead of the picture, or next to it.
export function tell(sentence, isBeside = false) {
  const trouble = document.getElementById('trouble');
  trouble.textContent = sentence;
  trouble.classList.toggle('beside', isBeside);
  trouble.hidden = false;
}
