// PNG files of 8 bits a channel, as small as the format allows: pictures to look at, and textures of the models.
import {deflateSync} from 'node:zlib';

/** CRC-32 of PNG and zlib. */
function crc(bytes) {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let bit = 0; bit < 8; ++bit) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  }
  return (value ^ 0xffffffff) >>> 0;
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const whole = Buffer.alloc(body.length + 8);
  whole.writeUInt32BE(data.length, 0);
  body.copy(whole, 4);
  whole.writeUInt32BE(crc(body), body.length + 4);
  return whole;
}

/** PNG's colour types, and how many bytes a pixel of each has. */
export const kGrey = 0, kRgb = 2, kPalette = 3, kRgba = 6;
const kBytes = {
  [kGrey]: 1,
  [kRgb]: 3,
  [kPalette]: 1,
  [kRgba]: 4
};

/** A PNG file. `pixels`: rows from the top, without gaps. `palette`: bytes of red, green, blue, with kPalette. */
export function encodePng(width, height, pixels, type = kRgba, palette = undefined) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header[8] = 8;
  header[9] = type;
  const row = width * kBytes[type];
  const filtered = Buffer.alloc((row + 1) * height);
  for (let y = 0; y < height; ++y)
    Buffer.from(pixels.subarray(y * row, (y + 1) * row)).copy(filtered, y * (row + 1) + 1);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
    chunk('IHDR', header),
    ...(palette ? [chunk('PLTE', Buffer.from(palette))] : []),
    chunk('IDAT', deflateSync(filtered)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}
