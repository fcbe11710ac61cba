// Files in a link: a line of JSON with paths and lengths, then the bytes; compressed, and in base64 for addresses.

export const kMaxPacked = 16384;  // characters

const through = async (bytes, transform) =>
  new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(transform)).arrayBuffer());

/** Characters of a link; `files`: [{path, bytes}]. */
export async function pack(files) {
  const head = JSON.stringify(files.map(({path, bytes}) => [path, bytes.length]));
  const plain = new Uint8Array(await new Blob([head, '\n', ...files.map(({bytes}) => bytes)]).arrayBuffer());
  const bytes = await through(plain, new CompressionStream('deflate-raw'));
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** The files of pack(). Throws an Error with words if a link has been damaged. */
export async function unpack(packed) {
  try {
    const bytes = Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), (each) => each.charCodeAt(0));
    const plain = await through(bytes, new DecompressionStream('deflate-raw'));
    let at = plain.indexOf(10) + 1;
    return JSON.parse(new TextDecoder().decode(plain.subarray(0, at))).map(([path, length]) => {
      at += length;
      return {path, bytes: plain.slice(at - length, at)};
    });
  } catch {
    throw new Error('the files in the link cannot be read: is a part of the link missing?');
  }
}
