// Draws baked scenes (.zsc, `zstrip bake MODEL -o scene.zsc`) in a page or in Node.js, with the pixels that a device shows.
//     const zstrip = await load();
//     const scene = await zstrip.open(bytes, { width: 240, height: 240, frames: 60 });
//     context.putImageData(new ImageData(scene.draw(0), scene.width, scene.height), 0, 0);

// The bytes of zstrip.wasm, for WebAssembly.compile. The file lies next to this one; pages fetch it, Node.js reads it.
const bytesOfModule = async () => {
  const place = new URL('zstrip.wasm', import.meta.url);
  if (place.protocol === 'file:') return (await import('node:fs/promises')).readFile(place);
  const response = await fetch(place);
  if (!response.ok) throw new Error(`zstrip.wasm: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
};

// One scene, with memory of its own. Errors are thrown, in words.
class Scene {
  #wasm;
  #picture;

  // `wasm`: what an instance of the module exports, which no other scene has.
  constructor(wasm, bytes, { width, height, frames = 1 }) {
    this.#wasm = wasm;
    const blob = wasm.reserve(bytes.byteLength);
    if (blob === 0) throw new Error('zstrip: no memory');
    const view = ArrayBuffer.isView(bytes) ? new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength) : new Uint8Array(bytes);
    new Uint8Array(wasm.memory.buffer, blob, view.length).set(view);
    this.#check(wasm.open(blob, view.length));
    // The animations that play() and advance() show: their names and durations.
    this.clips = Array.from({ length: wasm.clips() }, (_, clip) => {
      return { name: this.#text(wasm.clip_name(clip)), milliseconds: wasm.clip_time(clip) };
    });
    this.width = width ?? wasm.own_width();
    this.height = height ?? wasm.own_height();
    this.frames = frames;
    for (const [name, most] of [['width', 4096], ['height', 4096], ['frames', 0xffffffff]]) {
      if (!Number.isInteger(this[name]) || this[name] < 1 || this[name] > most) {
        throw new RangeError(`zstrip: ${name} is ${this[name]}, not a whole number from 1 to ${most}`);
      }
    }
    this.#check(wasm.prepare(this.width, this.height, frames));
    this.#picture = wasm.picture();
  }

  // Frame `frame` of `frames`, which show the animation once (of several clips the one that was played last), or else a full
  // turn: red, green, blue and alpha of each pixel. Valid until the next call. Any number of a frame: after the last one the
  // first one follows, and before it the last one.
  draw(frame) {
    const shown = Math.floor(frame) % this.frames;
    this.#check(this.#wasm.draw(shown < 0 ? shown + this.frames : shown));
    return this.#pixels();
  }

  // Plays a clip (its number, or its name) from its beginning. During `fade` milliseconds, at most 65535, the clips that play
  // go on and become this one.
  play(clip, { fade = 0, loops = true } = {}) {
    const number = typeof clip === 'string' ? this.clips.findIndex(({ name }) => name === clip) : clip;
    if (this.clips[number] === undefined) throw new RangeError(`zstrip: there is no clip ${clip}`);
    this.#wasm.play(number, Math.min(Math.max(Math.round(fade), 0), 0xffff), loops ? 1 : 0);
  }

  // Moves the clips that play on, and draws them: as draw().
  advance(milliseconds) {
    if (this.clips.length === 0) throw new Error('zstrip: the scene has no clips: draw its frames');
    this.#check(this.#wasm.advance(Math.max(Math.round(milliseconds), 0)));
    return this.#pixels();
  }

  // The numbers of the events that the clip that was played last has reached since the call before. Call it after advance().
  events() {
    const numbers = [];
    for (let number; (number = this.#wasm.next_event()) >= 0;) numbers.push(number);
    return numbers;
  }

  #pixels() {
    return new Uint8ClampedArray(this.#wasm.memory.buffer, this.#picture, 4 * this.width * this.height);
  }

  #text(address) {
    const bytes = new Uint8Array(this.#wasm.memory.buffer, address);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  #check(status) {
    if (status !== 0) throw new Error(`zstrip: ${this.#text(this.#wasm.words(status))}`);
  }
}

// `module`: a WebAssembly.Module of zstrip.wasm, where a bundler has it elsewhere.
export const load = async (module) => {
  const compiled = module ?? (await WebAssembly.compile(await bytesOfModule()));
  // Pages may not make a large instance while they wait.
  const open = async (bytes, options = {}) => new Scene((await WebAssembly.instantiate(compiled)).exports, bytes, options);
  return { open };
};
