// Makes a small animation of a folder of pictures: a PNG of at most 255 colours. Each frame has only the changed
// pixels.
// Run: zstrip render chess.toml -o frames --frames 36 --image ppm && node animate.mjs frames 8000 chess.png 48
import fs from 'node:fs';
import zlib from 'node:zlib';

import {chunk, readPicture} from './pictures.mjs';

const [, , folder, milliseconds, file, kColours = 255] = process.argv;
const kSame = 255;  // the index of pixels that stay

const frames = fs.readdirSync(folder)
                   .filter((name) => name.endsWith('.ppm'))
                   .sort()
                   .map((name) => readPicture(`${folder}/${name}`));
const {width, height} = frames[0];

// Counts the pixels of each colour. Boxes of colours are halved where the error is largest; then each mean moves to the
// mean of its nearest colours.
const counts = new Map();
const colourAt = ({pixels}, i) => pixels[3 * i] << 16 | pixels[3 * i + 1] << 8 | pixels[3 * i + 2];
for (const frame of frames) {
  for (let i = 0; i < width * height; ++i) counts.set(colourAt(frame, i), (counts.get(colourAt(frame, i)) ?? 0) + 1);
}
const colours =
    [...counts].map(([c, count]) => ({rgb: [c >> 16, c >> 8 & 255, c & 255], code: c, weight: count ** 0.7}));
const kWeights = [0.8, 1, 0.6];
function measured(box) {
  const weight = box.reduce((sum, c) => sum + c.weight, 0);
  const mean = [0, 1, 2].map((k) => box.reduce((sum, c) => sum + c.weight * c.rgb[k], 0) / weight);
  const spread =
      [0, 1, 2].map((k) => kWeights[k] * box.reduce((sum, c) => sum + c.weight * (c.rgb[k] - mean[k]) ** 2, 0));
  return {box, mean, axis: spread.indexOf(Math.max(...spread)), error: Math.max(...spread)};
}
let boxes = [measured(colours)];
while (boxes.length < kColours) {
  const worst = boxes.reduce((a, b) => (b.error > a.error ? b : a));
  if (worst.error === 0) break;
  const halves =
      [0, 1].map((side) => worst.box.filter((c) => (c.rgb[worst.axis] > worst.mean[worst.axis]) === (side === 1)));
  boxes = [...boxes.filter((b) => b !== worst), ...halves.map(measured)];
}
let palette = boxes.map((b) => b.mean);
const nearest = (rgb) => {
  let best = 0, least = Infinity;
  palette.forEach((p, i) => {
    const error =
        kWeights[0] * (p[0] - rgb[0]) ** 2 + kWeights[1] * (p[1] - rgb[1]) ** 2 + kWeights[2] * (p[2] - rgb[2]) ** 2;
    if (error < least) [best, least] = [i, error];
  });
  return best;
};
for (let round = 0; round < 4; ++round) {
  const members = palette.map(() => []);
  for (const c of colours) members[nearest(c.rgb)].push(c);
  palette = palette.map((p, i) => (members[i].length ? measured(members[i]).mean : p));
}
palette = palette.map((p) => p.map(Math.round));
const indices = new Map(colours.map((c) => [c.code, nearest(c.rgb)]));

const number = (value, bytes) => {
  const buffer = Buffer.alloc(bytes);
  buffer.writeUIntBE(value, 0, bytes);
  return buffer;
};
const kept = Buffer.alloc(width * height, kSame);
let sequence = 0;
const images = frames.map((frame, n) => {
  const rows = Buffer.alloc(height * (width + 1));
  for (let i = 0; i < width * height; ++i) {
    const index = indices.get(colourAt(frame, i)), at = Math.floor(i / width) * (width + 1) + 1 + i % width;
    rows[at] = n > 0 && kept[i] === index ? kSame : index;
    kept[i] = index;
  }
  const control = Buffer.concat([
    number(sequence++, 4), number(width, 4), number(height, 4), number(0, 4), number(0, 4),
    number(Math.round(milliseconds / frames.length), 2), number(1000, 2), number(0, 1), number(n > 0 ? 1 : 0, 1)
  ]);
  const packed = zlib.deflateSync(rows, {level: 9, memLevel: 9});
  return [
    chunk('fcTL', control),
    n > 0 ? chunk('fdAT', Buffer.concat([number(sequence++, 4), packed])) : chunk('IDAT', packed)
  ];
});
fs.writeFileSync(file, Buffer.concat([
  Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]),
  chunk('IHDR', Buffer.concat([number(width, 4), number(height, 4), Buffer.from([8, 3, 0, 0, 0])])),
  chunk('PLTE', Buffer.from([...palette, ...Array(256 - palette.length).fill([0, 0, 0])].flat())),
  chunk('tRNS', Buffer.from([...Array(255).fill(255), 0])),
  chunk('acTL', Buffer.concat([number(frames.length, 4), number(0, 4)])),
  ...images.flat(),
  chunk('IEND', Buffer.alloc(0)),
]));
