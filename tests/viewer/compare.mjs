// How far two pictures of one scene are apart. A mask has a byte a pixel, a picture red, green, blue and alpha.

/** Each pixel of the mask and its eight neighbours. */
export function dilate(mask, {width, height}) {
  const to = new Uint8Array(mask.length);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1) && !to[y * width + x]; ++v) {
        for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); ++u)
          to[y * width + x] |= mask[v * width + u];
      }
    }
  }
  return to;
}

const inverse = (mask) => mask.map((covered) => (covered ? 0 : 1));

/** Without the pixels beside one that is not covered; the border of the picture is none. */
export const erode = (mask, area) => inverse(dilate(inverse(mask), area));

/** Where two silhouettes, or their holes, are more than one pixel apart. */
export function silhouettesApart(a, b, area) {
  const apart = new Uint8Array(a.length);
  for (const [one, other] of [[a, b], [b, a], [inverse(a), inverse(b)], [inverse(b), inverse(a)]]) {
    const allowed = dilate(other, area);
    for (let i = 0; i < apart.length; ++i) apart[i] |= one[i] && !allowed[i] ? 1 : 0;
  }
  return apart;
}

/** What a channel of 8 bits is after RGB565, widened again. */
export function toRgb565(picture) {
  const to = new Uint8Array(picture.length);
  for (let i = 0; i < picture.length; i += 4) {
    const r = picture[i] >> 3, g = picture[i + 1] >> 2, b = picture[i + 2] >> 3;
    to.set([(r << 3) | (r >> 2), (g << 2) | (g >> 4), (b << 3) | (b >> 2), 255], i);
  }
  return to;
}

/** Whether a pixel's colour is, within `step` a channel, that of the same pixel or of a neighbour in `other`. */
function isNear(picture, other, x, y, {width, height, step}) {
  const at = 4 * (y * width + x);
  for (let v = Math.max(y - 1, 0); v <= Math.min(y + 1, height - 1); ++v) {
    for (let u = Math.max(x - 1, 0); u <= Math.min(x + 1, width - 1); ++u) {
      const there = 4 * (v * width + u);
      let apart = 0;
      for (let c = 0; c < 3; ++c) apart = Math.max(apart, Math.abs(picture[at + c] - other[there + c]));
      if (apart <= step) return true;
    }
  }
  return false;
}

/**
 * The mask's pixels whose colour is not, within `area.step` a channel, in the other picture at most one pixel away.
 */
export function coloursApart(a, b, mask, area) {
  return mask.map((covered, i) => {
    const x = i % area.width, y = Math.floor(i / area.width);
    return covered && !(isNear(a, b, x, y, area) && isNear(b, a, x, y, area)) ? 1 : 0;
  });
}

/** The largest difference of the mean of a channel in a tile of 8x8 pixels, of those that lie in the mask. */
export function tilesApart(a, b, mask, {width, height}) {
  const kSide = 8, kFewest = 16;
  let largest = 0;
  for (let top = 0; top < height; top += kSide) {
    for (let left = 0; left < width; left += kSide) {
      const sum = [0, 0, 0];
      let pixels = 0;
      for (let y = top; y < Math.min(top + kSide, height); ++y) {
        for (let x = left; x < Math.min(left + kSide, width); ++x) {
          const at = y * width + x;
          if (!mask[at]) continue;
          ++pixels;
          for (let c = 0; c < 3; ++c) sum[c] += a[4 * at + c] - b[4 * at + c];
        }
      }
      if (pixels >= kFewest) largest = Math.max(largest, ...sum.map((each) => Math.abs(each) / pixels));
    }
  }
  return largest;
}
