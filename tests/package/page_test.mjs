// page_test.mjs CHROMIUM SCRATCH EXPECTED: a page with the package shows frame 0 of a scene in Chromium as EXPECTED, a picture
// in RGB565, low byte first. SCRATCH has `package` and `scenes`.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { showPage } from '../viewer/chromium.mjs';

const [chromium, scratch, expectedFile] = process.argv.slice(2);
const expected = readFileSync(expectedFile);
let pictures = 0;
await showPage({
  chromium,
  profile: join(scratch, 'profile'),
  folders: {
    page: new URL('page', import.meta.url).pathname,
    package: join(scratch, 'package'),
    scenes: join(scratch, 'scenes'),
  },
  async onPost(path, drawn) {
    assert.equal(path, '/picture');
    assert.equal(drawn.length, 2 * expected.length);
    for (let i = 0; i < expected.length / 2; ++i) {
      const [red, green, blue] = drawn.subarray(4 * i, 4 * i + 3);
      const pixel = ((red >> 3) << 11) | ((green >> 2) << 5) | (blue >> 3);
      assert.equal(pixel, expected.readUInt16LE(2 * i), `pixel ${i % 160}, ${Math.floor(i / 160)}`);
    }
    ++pictures;
  },
  seconds: 60,
});
assert.equal(pictures, 1);
