// The picture, whose strips come as late as a board sends them, and their borders above it.
const canvas = document.getElementById('canvas');
const marks = document.getElementById('marks');
let arrival = 0;
let arrived = true;

// Returns false while strips of the picture have not arrived yet.
export const hasArrived = () => arrived;

function mark(strips, lit) {
  const context = marks.getContext('2d');
  context.clearRect(0, 0, marks.width, marks.height);
  strips.forEach(({left, top, right, bottom}, i) => {
    context.fillStyle = '#ffd54f55';
    if (i === lit) context.fillRect(left, top, right - left, bottom - top);
    context.strokeStyle = '#ff6f00';
    context.strokeRect(left + 0.5, top + 0.5, right - left - 1, bottom - top - 1);
  });
}

// Shows the picture of worker.mjs. `borders`: draws them around each strip; `slow`: shows each strip when it would
// arrive.
export function showPicture({figures, pixels}, borders, slow) {
  cancelAnimationFrame(arrival);
  arrived = true;
  canvas.classList.remove('empty');
  const {width, height, strips} = figures;
  const image = new ImageData(new Uint8ClampedArray(pixels), width, height);
  if (canvas.width !== width || canvas.height !== height) {
    for (const each of [canvas, marks]) [each.width, each.height] = [width, height];
  }
  const context = canvas.getContext('2d');
  const marked = borders ? strips : [];
  if (!slow || !strips.some((strip) => 'send_end' in strip)) {
    context.putImageData(image, 0, 0);
    mark(marked, -1);
    return;
  }
  const begun = performance.now();
  let next = 0;
  arrived = false;
  const step = () => {
    const now = (performance.now() - begun) / 1000;
    for (; next < strips.length && strips[next].send_end <= now; ++next) {
      const {left, top, right, bottom} = strips[next];
      context.putImageData(image, 0, 0, left, top, right - left, bottom - top);
    }
    mark(marked, strips.findIndex((strip) => strip.draw_begin <= now && now < strip.draw_end));
    arrived = next === strips.length;
    if (!arrived) arrival = requestAnimationFrame(step);
  };
  step();
}

export function clearPicture() {
  cancelAnimationFrame(arrival);
  arrived = true;
  for (const each of [canvas, marks]) each.getContext('2d').clearRect(0, 0, each.width, each.height);
  canvas.classList.add('empty');
}
