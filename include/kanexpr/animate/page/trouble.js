// What a reader has to be told instead of the picture, or beside it.
export function tell(sentence, isBeside = false) {
  const trouble = document.getElementById('trouble');
  trouble.textContent = sentence;
  trouble.classList.toggle('beside', isBeside);
  trouble.hidden = false;
}
