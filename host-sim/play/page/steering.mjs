// Mouse, touch, wheel and keys over the picture move the camera around the scene.
const kDegreesOfPixel = 0.4;
const kDegreesOfKey = 5;
const canvas = document.getElementById('canvas');

/** `turn` is called with degrees to the right and down, `zoom` with steps closer. */
export function listenToSteering(turn, zoom) {
  const keys = {
    ArrowLeft: () => turn(-kDegreesOfKey, 0),
    ArrowRight: () => turn(kDegreesOfKey, 0),
    ArrowUp: () => turn(0, -kDegreesOfKey),
    ArrowDown: () => turn(0, kDegreesOfKey),
    '+': () => zoom(1),
    '-': () => zoom(-1),
  };
  canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0) turn(event.movementX * kDegreesOfPixel, event.movementY * kDegreesOfPixel);
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
