// Mouse, touch, wheel and keys over the picture move the camera around the scene; a click names a pixel.
const kDegreesOfPixel = 0.4;
const kDegreesOfKey = 5;
const kMaxSteady = 3;  // pixels that a hand moves in a click
const canvas = document.getElementById('canvas');

// The pixel of the picture at a place of the canvas, which has borders where its shape differs.
function pixelAt({offsetX, offsetY}) {
  const {width, height, clientWidth, clientHeight} = canvas;
  const scale = Math.min(clientWidth / width, clientHeight / height);
  return [Math.floor((offsetX - (clientWidth - width * scale) / 2) / scale),
          Math.floor((offsetY - (clientHeight - height * scale) / 2) / scale)];
}

/** `turn` is called with degrees to the right and down, `zoom` with steps closer, `pick` with a pixel of the picture. */
export function listenToSteering(turn, zoom, pick) {
  let moved = 0;
  const keys = {
    ArrowLeft: () => turn(-kDegreesOfKey, 0),
    ArrowRight: () => turn(kDegreesOfKey, 0),
    ArrowUp: () => turn(0, -kDegreesOfKey),
    ArrowDown: () => turn(0, kDegreesOfKey),
    '+': () => zoom(1),
    '-': () => zoom(-1),
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    moved = 0;
  });
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons === 0) return;
    moved += Math.abs(event.movementX) + Math.abs(event.movementY);
    if (moved > kMaxSteady) turn(event.movementX * kDegreesOfPixel, event.movementY * kDegreesOfPixel);
  });
  canvas.addEventListener('click', (event) => {
    const [x, y] = pixelAt(event);
    if (moved <= kMaxSteady && x >= 0 && y >= 0 && x < canvas.width && y < canvas.height) pick(x, y);
  });
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(-Math.sign(event.deltaY));
  }, {passive: false});
  canvas.addEventListener('keydown', (event) => {
    if (!(event.key in keys)) return;
    event.preventDefault();
    keys[event.key]();
  });
}
