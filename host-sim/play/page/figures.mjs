// The tables next to the picture: memory by purpose, work, and the estimated speed of boards.
import {nameOfBoard} from './settings_form.mjs';

const kPurposes = {
  instances: 'placed instances',
  extents: 'extents',
  vertices: 'vertices',
  depth: 'depth',
  colour: 'colour',
  bins: 'lists of the strips',
  effects: 'effects',
  strip_pixels: 'pixels of the strips'
};

// `rows`: a name, a number or text, and true if the row stands out.
function fill(id, rows) {
  document.getElementById(id).tBodies[0].replaceChildren(...rows.map(([name, value, isMain]) => {
    const row = document.createElement('tr');
    row.className = isMain ? 'main' : '';
    const head = document.createElement('th');
    head.scope = 'row';
    head.textContent = name;
    const cell = document.createElement('td');
    cell.textContent = typeof value === 'number' ? value.toLocaleString('en') : value;
    row.append(head, cell);
    return row;
  }));
}

const inUnits = (difference) => difference.toPrecision(3);

// Shows the accuracy of a frame that was compared with the truth; hides it for other frames.
function showAccuracy(accuracy) {
  document.getElementById('accuracy').hidden = !accuracy;
  if (!accuracy) return;
  document.getElementById('accuracy-key').replaceChildren(...accuracy.key.map(([difference, colour], i) => {
    const item = document.createElement('li');
    const swatch = document.createElement('span');
    swatch.style.background = colour;
    item.append(swatch, i + 1 < accuracy.key.length ? difference : `${difference} or more`);
    return item;
  }));
  fill('accuracy-figures', [
    ['worst pixel', `${inUnits(accuracy.worst)} at ${accuracy.worst_x}, ${accuracy.worst_y}`],
    ['pixels that differ visibly', `${accuracy.seen_percent.toFixed(1)} %`],
    ['mean', inUnits(accuracy.mean)]
  ]);
}

const kilobytes = (bytes) => (bytes / 1024).toFixed(bytes < 10240 ? 1 : 0);

// Shows the most important figures below the picture. A rate is "12" or "8 to 17", or says what a board lacks.
function showHeadline(total, {strips, flash_bytes, rates}, board, isShown) {
  const rate = rates[board] ?? '', isRate = /^\d/.test(rate);
  const few = rate.replace(/[\d.]+/g, (digits) => String(Number(Number(digits).toPrecision(2))));
  for (const [id, text] of [
    ['ram', `${kilobytes(total)} KB of RAM`],
    ['strips', strips.length > 1 ? `in ${strips.length} strips` : 'for the picture and all else'],
    ['flash', `${kilobytes(flash_bytes)} KB of flash`],
    ['rate', isRate ? `about ${few} frames/s` : rate],
    ['board', board ? `on ${nameOfBoard(board)}${isRate ? `, ${isShown ? 'as' : 'not as'} shown` : ''}` : '']
  ]) document.getElementById(`headline-${id}`).textContent = text;
}

// Shows the figures of a frame that worker.mjs has drawn. `board`: the chosen board, or nothing;
// `isShown`: true if the picture is shown at its speed.
export function showFigures(figures, board, isShown) {
  const purposes = Object.entries(figures.ram_bytes).filter(([name, bytes]) => name in kPurposes && bytes !== 0);
  const total = purposes.reduce((sum, [, bytes]) => sum + bytes, 0);
  showHeadline(total, figures, board, isShown);
  fill('memory', [...purposes.map(([name, bytes]) => [kPurposes[name], bytes]), ['together', total, true]]);
  fill('work', [
    ['triangles', figures.triangles], ['of these drawn', figures.drawn], ['fragments', figures.fragments],
    ['instructions of a Cortex-M3, about', figures.m3_instructions], ['flash of the scene, bytes', figures.flash_bytes]
  ]);
  showAccuracy(figures.accuracy);
  fill('boards', Object.entries(figures.rates).map(([name, rate]) => [nameOfBoard(name), rate, name === board]));
  showLeftOut(figures.estimate_leaves_out);
}

function showLeftOut(effects) {
  document.getElementById('left-out').textContent = effects.length > 0 ? `The estimates leave out: ${effects.join(', ')}.` : '';
}

export function clearFigures() {
  for (const id of ['memory', 'work', 'boards']) fill(id, []);
  for (const each of document.querySelectorAll('#headline dd')) each.textContent = '';
  showAccuracy(null);
  showLeftOut([]);
}
