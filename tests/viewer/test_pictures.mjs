// A picture for textures, in several kinds of PNG file.
import {encodePng, kGrey, kPalette, kRgb} from './png.mjs';

/** Sixteen fields of different colours, all of RGB565: no turn and no mirror makes the same of them. */
function fields(width = 8, height = 8, alpha = () => 255) {
  const pixels = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const u = Math.floor((4 * x) / width), v = Math.floor((4 * y) / height);
      const widen = (value, bits) => Math.round((value * 255) / (2 ** bits - 1));
      pixels.set(
          [
            widen(4 + 9 * u, 5), widen(8 + 16 * v, 6), widen(u === 0 && v === 0 ? 31 : 2 + 5 * ((u + v) & 3), 5),
            alpha(u, v)
          ],
          4 * (y * width + x));
    }
  }
  return pixels;
}
export const fieldsPng = (width = 8, height = 8, alpha = undefined) =>
    encodePng(width, height, fields(width, height, alpha));

export function greyFields() {
  const pixels = fields();
  return encodePng(8, 8, Uint8Array.from({length: 64}, (_, i) => pixels[4 * i]), kGrey);
}

export function rgbFields() {
  const pixels = fields();
  return encodePng(8, 8, Uint8Array.from({length: 192}, (_, i) => pixels[4 * Math.floor(i / 3) + (i % 3)]), kRgb);
}

export function paletteFields() {
  const pixels = fields();
  const palette = [], indices = new Uint8Array(64);
  for (let i = 0; i < 64; ++i) {
    indices[i] = 4 * Math.floor(i / 16) + Math.floor((i % 8) / 2);
    palette.splice(3 * indices[i], 3, ...pixels.subarray(4 * i, 4 * i + 3));
  }
  return encodePng(8, 8, indices, kPalette, palette);
}
