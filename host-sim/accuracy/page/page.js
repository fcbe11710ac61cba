'use strict';
// Hovering names a point, clicking shows its pictures, the boxes on top filter. Without this the page is whole, too.
const figures = [['perceived', 'visible error'], ['flip', 'FLIP'], ['wrong_pixels', 'wrong pixels, %'], ['silhouette', 'silhouette, pixels'],
  ['depth_view', 'depth, units'], ['texture', 'texture, texels'], ['colour_mean', 'colour, mean'], ['flicker', 'flicker']];
const tip = document.body.appendChild(Object.assign(document.createElement('div'), { id: 'tip', hidden: true }));
const number = (value) => value === null || value === undefined ? '–'
  : Math.abs(value) >= 1000 ? Math.round(value).toLocaleString('en') : String(+value.toPrecision(3));

const scenes = [...document.querySelectorAll('section.scene')].map((section) => {
  const scene = JSON.parse(section.querySelector('script.data').textContent);
  scene.section = section;
  scene.circles = [...section.querySelectorAll('circle[data-point]')];
  scene.rows = [...section.querySelectorAll('tbody tr[data-point]')];
  return scene;
});

function summary(point) {
  const cost = point.cost;
  const time = cost.instructions === null ? `${number(cost.nanoseconds / 1000)} µs` : `${number(cost.instructions)} instructions`;
  const fps = cost.least_fps === null ? '' : `, ${number(cost.least_fps)} to ${number(cost.most_fps)} frames a second`;
  return `${time}${fps}, RAM ${number(cost.ram_bytes)} bytes\nvisible error ${number(point.errors.perceived)}, ` +
    `wrong pixels ${number(point.errors.wrong_pixels)} %, PSNR ${number(point.errors.psnr)} dB`;
}

// Lists the error that each stage of drawing causes alone with these settings, if it was measured.
function causesOf(scene, point) {
  const own = scene.causes.filter((c) => Object.keys(c.knobs).every((k) => c.knobs[k] === point.knobs[k]));
  return own.length === 0 ? '' : '\nvisible error of each cause alone: ' + own.map((c) => `${c.cause} ${number(c.perceived)}`).join(', ');
}

function pictureOf(url) {
  return new Promise((resolve) => {
    const image = new Image();
    image.onload = () => resolve(image);
    image.src = url;
  });
}

// The corner of the part of this size where the heat map is brightest.
function worstPart(image, width, height) {
  const canvas = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(image, 0, 0);
  const data = context.getImageData(0, 0, image.width, image.height).data;
  let best = [0, 0], most = -1;
  for (let y = 0; y + height <= image.height; y += 4) {
    for (let x = 0; x + width <= image.width; x += 4) {
      let sum = 0;
      for (let dy = 0; dy < height; dy += 2) {
        for (let dx = 0; dx < width; dx += 2) {
          const at = 4 * ((y + dy) * image.width + x + dx);
          sum += data[at] + data[at + 1] + data[at + 2];
        }
      }
      if (sum > most) { most = sum; best = [x, y]; }
    }
  }
  return best;
}

function figureOf(source, caption, part) {
  const figure = document.createElement('figure');
  const canvas = document.createElement('canvas');
  const [x, y, width, height] = part || [0, 0, source.width, source.height];
  canvas.width = width;
  canvas.height = height;
  canvas.getContext('2d').drawImage(source, x, y, width, height, 0, 0, width, height);
  figure.append(canvas, Object.assign(document.createElement('figcaption'), { textContent: caption }));
  return figure;
}

async function choose(scene, index) {
  const point = scene.points[index];
  for (const element of [...scene.circles, ...scene.rows]) {
    element.classList.toggle('chosen', +element.dataset.point === index);
  }
  const row = scene.rows.find((r) => +r.dataset.point === index);
  const detail = scene.section.querySelector('.detail');
  const title = Object.assign(document.createElement('h3'), { textContent: point.settings });
  const words = Object.assign(document.createElement('p'), { textContent: summary(point) + causesOf(scene, point) });
  words.style.whiteSpace = 'pre-line';
  const command = Object.assign(document.createElement('p'), {});
  command.append(Object.assign(document.createElement('code'), { textContent: row.querySelector('code').textContent }));
  const whole = Object.assign(document.createElement('div'), { className: 'pictures' });
  const zoomed = Object.assign(document.createElement('div'), { className: 'pictures' });
  let pictures = scene.pictures[index];
  if (!pictures) {
    // Strips change no pixel: the pictures are those of the point that differs in nothing else.
    const other = scene.points.findIndex((p, i) => scene.pictures[i] &&
      Object.keys(p.knobs).every((k) => k === 'strips' || p.knobs[k] === point.knobs[k]));
    pictures = scene.pictures[other];
  }
  if (pictures) {
    const [drawn, truth, heat] = await Promise.all([pictureOf(pictures.drawn), pictureOf(scene.truth), pictureOf(pictures.heat)]);
    const width = Math.min(48, drawn.width), height = Math.min(36, drawn.height);
    const part = [...worstPart(heat, width, height), width, height];
    whole.append(figureOf(drawn, 'drawn'), figureOf(truth, 'truth'), figureOf(heat, 'error'));
    zoomed.append(figureOf(drawn, 'where it is worst', part), figureOf(truth, 'truth', part), figureOf(heat, 'error', part));
  } else {
    whole.textContent = 'No pictures of this combination are on the page; the command above draws them.';
  }
  detail.replaceChildren(title, words, command, whole, zoomed);
  detail.dataset.shown = point.settings;
}

// Moves the points to another error; logarithmic, as the drawing was.
function showFigure(name) {
  for (const scene of scenes) {
    const values = scene.points.map((p) => p.errors[name]);
    const known = values.filter((v) => v !== null);
    const svg = scene.section.querySelector('svg');
    scene.section.querySelector('svg text[transform]').textContent = figures.find((f) => f[0] === name)[1];
    svg.querySelectorAll('.front, .recommended, .y').forEach((e) => e.remove());
    [...svg.querySelectorAll('text[font-weight], text[text-anchor=end], path[d*=H]')].forEach((e) => e.remove());
    const floor = Math.min(...known.filter((v) => v > 0)) / 1.5;
    const low = Math.log10(Number.isFinite(floor) ? floor : 0.1), high = Math.log10(Math.max(...known, 0.2) * 1.2);
    const at = (value) => 378 - (Math.log10(Math.max(value, 10 ** low)) - low) / (high - low || 1) * 364;
    for (let decade = Math.floor(low); decade <= high; decade += 1) {
      for (const digit of [1, 2, 5]) {
        const value = digit * 10 ** decade;
        if (Math.log10(value) < low || Math.log10(value) > high) continue;
        svg.querySelector('rect').insertAdjacentHTML('afterend',
          `<g class="y"><path d="M62 ${at(value)}h678" stroke="#eee"/><text x="56" y="${at(value) + 4}" text-anchor="end" fill="#555">${number(value)}</text></g>`);
      }
    }
    scene.circles.forEach((circle) => {
      const value = values[+circle.dataset.point];
      circle.toggleAttribute('hidden', value === null);
      circle.setAttribute('cy', value === null ? 0 : at(value));
    });
  }
  filter();
}

const off = new Set();
let frontOnly = false;
function filter() {
  for (const scene of scenes) {
    for (const element of [...scene.circles, ...scene.rows]) {
      const point = scene.points[+element.dataset.point];
      element.style.display = off.has(point.group) || (frontOnly && !point.front) ? 'none' : '';
    }
  }
}

function box(text, checked, colour, change) {
  const label = document.createElement('label');
  const input = Object.assign(document.createElement('input'), { type: 'checkbox', checked });
  input.addEventListener('change', () => change(input.checked));
  label.append(input);
  if (colour) label.append(Object.assign(document.createElement('i'), { style: `background:${colour};margin:0` }));
  label.append(text);
  label.dataset.filter = text;
  return label;
}

const nav = document.getElementById('filters');
const groups = new Map();
scenes.forEach((scene) => scene.circles.forEach((c) => groups.set(c.dataset.group, c.getAttribute('fill'))));
for (const [group, colour] of [...groups].sort((a, b) => (a[0] === 'several') - (b[0] === 'several') || (a[0] > b[0] ? 1 : -1))) {
  nav.append(box(group, true, colour, (on) => { on ? off.delete(group) : off.add(group); filter(); }));
}
nav.append(box('only the front', false, null, (on) => { frontOnly = on; filter(); }));
const select = document.createElement('select');
for (const [name, text] of figures) select.append(new Option(text, name));
select.addEventListener('change', () => showFigure(select.value));
const errorLabel = document.createElement('label');
errorLabel.append('error shown: ', select);
nav.append(errorLabel);
if (scenes.length > 1) {
  const chooser = document.createElement('select');
  chooser.append(new Option('all scenes', ''));
  scenes.forEach((s, i) => chooser.append(new Option(s.section.querySelector('h2').textContent, i)));
  chooser.addEventListener('change', () => scenes.forEach((s, i) => { s.section.hidden = chooser.value !== '' && +chooser.value !== i; }));
  nav.append(chooser);
}

for (const scene of scenes) {
  for (const element of [...scene.circles, ...scene.rows]) {
    const index = +element.dataset.point;
    element.addEventListener('click', () => choose(scene, index));
    if (element.tagName !== 'circle') continue;
    element.querySelector('title').remove();
    element.addEventListener('pointermove', (event) => {
      tip.textContent = `${scene.points[index].settings}\n${summary(scene.points[index])}`;
      tip.hidden = false;
      tip.style.left = `${Math.min(event.pageX + 14, document.documentElement.clientWidth - tip.offsetWidth - 8)}px`;
      tip.style.top = `${event.pageY + 14}px`;
    });
    element.addEventListener('pointerleave', () => { tip.hidden = true; });
  }
  choose(scene, scene.points.findIndex((p) => p.settings === 'default'));
}
