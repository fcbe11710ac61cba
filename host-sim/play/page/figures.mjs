// The tables beside the picture: memory by its purpose, work, and about how fast boards are.
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

// Rows of a name, a number or text, and whether it is a sum.
function fill(id, rows) {
  document.getElementById(id).tBodies[0].replaceChildren(...rows.map(([name, value, isTotal]) => {
    const row = document.createElement('tr');
    row.className = isTotal ? 'total' : '';
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

// Only of a frame that was compared with the truth.
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
    ['pixels that are seen to differ', `${accuracy.seen_percent.toFixed(1)} %`],
    ['mean', inUnits(accuracy.mean)]
  ]);
}

// Shows the figures of a frame that worker.mjs has drawn.
export function showFigures(figures) {
  const purposes = Object.entries(figures.ram_bytes).filter(([name, bytes]) => name in kPurposes && bytes !== 0);
  const total = purposes.reduce((sum, [, bytes]) => sum + bytes, 0);
  fill('memory', [...purposes.map(([name, bytes]) => [kPurposes[name], bytes]), ['together', total, true]]);
  fill('work', [
    ['triangles', figures.triangles], ['of these drawn', figures.drawn], ['fragments', figures.fragments],
    ['instructions of a Cortex-M3, about', figures.m3_instructions], ['flash of the scene, bytes', figures.flash_bytes]
  ]);
  showAccuracy(figures.accuracy);
  fill('boards', Object.entries(figures.rates));
  showLeftOut(figures.estimate_leaves_out);
}

function showLeftOut(effects) {
  document.getElementById('left-out').textContent = effects.length > 0 ? `The estimates leave out: ${effects.join(', ')}.` : '';
}

export function clearFigures() {
  for (const id of ['memory', 'work', 'boards']) fill(id, []);
  showAccuracy(null);
  showLeftOut([]);
}
