// npm.mjs SCENE FRAMES...: the package `zstrip`, found as Node.js finds packages, draws the scene SCENE (.zsc) as the command
// has: each of FRAMES is a picture in RGB565, low byte first. What is no scene is an error in words. Without FRAMES the
// scene must be refused.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { load } from 'zstrip';

const [file, ...frames] = process.argv.slice(2);
const zstrip = await load();
const bytes = readFileSync(file);
if (frames.length === 0) {
  await assert.rejects(zstrip.open(bytes), /^Error: zstrip: [a-z]/);
  process.exit();
}
const scene = await zstrip.open(bytes, { width: 160, height: 120, frames: frames.length });

frames.forEach((name, frame) => {
  const expected = readFileSync(name);
  const drawn = scene.draw(frame);
  assert.equal(drawn.length, 2 * expected.length);
  for (let i = 0; i < expected.length / 2; ++i) {
    const [red, green, blue, alpha] = drawn.subarray(4 * i, 4 * i + 4);
    const pixel = ((red >> 3) << 11) | ((green >> 2) << 5) | (blue >> 3);
    assert.equal(pixel, expected.readUInt16LE(2 * i), `${name}: pixel ${i % 160}, ${Math.floor(i / 160)}`);
    assert.equal(alpha, 255);
    assert.equal(red & 7, red >> 5);  // white is 255
  }
});

// WebAssembly gets 32 bits of a number: others were other frames.
for (const [number, frame] of [[-1, frames.length - 1], [2 ** 32 + 1, (2 ** 32 + 1) % frames.length], [0.5, 0]]) {
  assert.deepEqual(scene.draw(number).slice(), scene.draw(frame), `frame ${number}`);
}

// Clips: at a frame's time they are that frame; in the middle of a fade they are neither clip.
if (scene.clips.length > 1) {
  const [first, second] = scene.clips;
  if (first.name === 'talk') {
    assert.deepEqual(scene.events(), [7], 'at its beginning');
    scene.advance(600);
    assert.deepEqual(scene.events(), [9]);
    assert.deepEqual(scene.events(), []);
    scene.play('puff');
    scene.advance(799);
    assert.deepEqual(scene.events(), [2]);
    scene.play(0);
    scene.advance(0);
  }
  const frame = scene.draw(1).slice();
  scene.play(first.name);
  assert.deepEqual(scene.advance(Math.floor(first.milliseconds / frames.length)), new Uint8ClampedArray(frame));
  const alone = [100, 200].map((time) => {
    scene.play(1);
    return scene.advance(time).slice();
  });
  scene.play(0);
  scene.play(second.name, { fade: 200, loops: false });
  assert.notDeepEqual(scene.advance(100), alone[0]);
  assert.deepEqual(scene.advance(100), alone[1]);
  scene.advance(10 * second.milliseconds);
  const end = scene.advance(0).slice();
  assert.deepEqual(scene.advance(1234), end);
  assert.throws(() => scene.play('nothing'), RangeError);
  assert.throws(() => scene.play(scene.clips.length), RangeError);
} else {
  assert.throws(() => scene.advance(1), /no clips/);
}

const own = await zstrip.open(bytes);
assert(own.width > 0 && own.height > 0 && own.draw(0).length === 4 * own.width * own.height);
await assert.rejects(zstrip.open(bytes.subarray(0, 100)), /^Error: zstrip: .*damaged/);
await assert.rejects(zstrip.open(bytes, { width: 5000 }), RangeError);
await assert.rejects(zstrip.open(bytes, { frames: 0 }), RangeError);
