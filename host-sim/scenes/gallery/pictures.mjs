// Writes textures as PNG: pictures that a function paints.
import fs from 'node:fs';
import zlib from 'node:zlib';

function crc32(bytes) {
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}

export function chunk(type, content) {
  const typed = Buffer.concat([Buffer.from(type), content]), bytes = Buffer.alloc(typed.length + 8);
  bytes.writeUInt32BE(content.length);
  typed.copy(bytes, 4);
  bytes.writeUInt32BE(crc32(typed), typed.length + 4);
  return bytes;
}

// paint(u, v) returns [red, green, blue], or these and alpha, 0 to 255. u goes to the right and v down, 0 to 1. Each
// texel is the mean of `samples` times `samples` calls.
export function writePicture(file, width, height, paint, {alpha = false, samples = 4} = {}) {
  const channels = alpha ? 4 : 3, rows = Buffer.alloc(height * (1 + width * channels));
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const sum = [0, 0, 0, 0];
      for (let j = 0; j < samples; ++j) {
        for (let i = 0; i < samples; ++i) {
          const [r, g, b, a = 255] = paint((x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height);
          [r * a, g * a, b * a, a].forEach((v, k) => (sum[k] += v));
        }
      }
      const at = y * (1 + width * channels) + 1 + x * channels;
      for (let k = 0; k < 3; ++k) rows[at + k] = Math.round(Math.min(255, Math.max(0, sum[3] ? sum[k] / sum[3] : 0)));
      if (alpha) rows[at + 3] = Math.round(sum[3] / samples ** 2);
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width);
  head.writeUInt32BE(height, 4);
  head[8] = 8;
  head[9] = alpha ? 6 : 2;
  fs.writeFileSync(file, Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk('IHDR', head),
    chunk('IDAT', zlib.deflateSync(rows, {level: 9})), chunk('IEND', Buffer.alloc(0))
  ]));
}

// Reads a PPM of 8 bits a channel.
export function readPicture(file) {
  const bytes = fs.readFileSync(file),
        [head, width, height] = /^P6\s+(\d+)\s+(\d+)\s+255\s/.exec(bytes.latin1Slice(0, 32));
  return {width: Number(width), height: Number(height), pixels: bytes.subarray(head.length)};
}
