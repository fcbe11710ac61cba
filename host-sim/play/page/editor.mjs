// The text of the scene file, which is edited in the page; the line of an error is marked.

const kQuiet = 200;  // milliseconds without a key, until the text is taken
const element = (id) => document.getElementById(id);
let waiting = 0;

/** `text` undefined: the scene has none; `canBegin`: it can get one. */
export function showText(text, isEdited, canBegin) {
  element('scene-file').hidden = text === undefined && !canBegin;
  element('begin').hidden = !canBegin;
  element('editor').hidden = text === undefined;
  element('original').hidden = !isEdited;
  const area = element('text');
  if (text !== undefined && area.value !== text) {
    area.value = text;
    area.scrollTop = 0;
  }
}

export const shownText = () => element('text').value;

/** `error` as lineOfError() returns it; undefined: nothing is wrong. */
export function markError(error) {
  const area = element('text'), note = element('text-error');
  note.hidden = !error;
  note.textContent = error ? `Line ${error.line}: ${error.words}` : '';
  area.classList.toggle('wrong', Boolean(error));
  area.toggleAttribute('aria-invalid', Boolean(error));
  area.style.setProperty('--wrong-row', error?.line ?? 0);
}

/** All are called without arguments. */
export function listenToText(edited, restored, begun) {
  element('text').addEventListener('input', () => {
    clearTimeout(waiting);
    waiting = setTimeout(edited, kQuiet);
  });
  element('original').addEventListener('click', restored);
  element('begin').addEventListener('click', begun);
}
