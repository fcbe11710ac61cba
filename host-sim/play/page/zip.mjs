// A zip file of a few small files, stored as they are.

const kTable = Uint32Array.from({length: 256}, (_, index) => {
  let value = index;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});
const crcOf = (bytes) => ~bytes.reduce((crc, byte) => kTable[(crc ^ byte) & 255] ^ (crc >>> 8), ~0) >>> 0;

const kVersion = 20, kUtf8 = 0x800, kDate = 0x21;  // 1980-01-01: the same files are the same zip file

// Little endian; a number is [value, bytes].
function record(...parts) {
  return parts.flatMap((part) => {
    if (!Array.isArray(part)) return [...part];
    return Array.from({length: part[1]}, (_, i) => (part[0] >>> (8 * i)) & 255);
  });
}

/** `files`: [{path, bytes}]. */
export function zipOf(files) {
  const parts = [], directory = [];
  let offset = 0;
  for (const {path, bytes} of files) {
    const name = new TextEncoder().encode(path);
    const fields = record([kVersion, 2], [kUtf8, 2], [0, 2], [0, 2], [kDate, 2], [crcOf(bytes), 4], [bytes.length, 4],
      [bytes.length, 4], [name.length, 2], [0, 2]);
    const header = Uint8Array.from([...record([0x04034b50, 4]), ...fields, ...name]);
    directory.push(...record([0x02014b50, 4], [kVersion, 2]), ...fields, ...record([0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]), ...name);
    parts.push(header, bytes);
    offset += header.length + bytes.length;
  }
  const end = record([0x06054b50, 4], [0, 2], [0, 2], [files.length, 2], [files.length, 2], [directory.length, 4], [offset, 4], [0, 2]);
  const all = [...parts, Uint8Array.from([...directory, ...end])];
  const zip = new Uint8Array(all.reduce((sum, {length}) => sum + length, 0));
  let at = 0;
  for (const part of all) {
    zip.set(part, at);
    at += part.length;
  }
  return zip;
}
