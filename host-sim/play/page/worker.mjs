// Draws in the background, so that the page stays responsive. Calls are {id, name, values}, and are answered in order.
import {Drawing} from './drawing.mjs';

let drawing;
let files = [];
let shown = 0;

async function load() {
  if (drawing) return;
  drawing = await Drawing.load((await import('./zstrip.mjs')).default);
  drawing.addFiles(files);
}

const calls = {
  async addFiles(added) {
    files = [...files, ...added];
    drawing?.addFiles(added);
  },
  async open({scene, options}) {
    await load();
    const opened = await drawing.open(scene, options);
    shown = 0;
    return opened;
  },
  async draw(view) {
    const drawn = await drawing.draw(view, shown);
    shown = drawn.figures.frame;
    return drawn;
  },
  async pick({x, y}) {
    return drawing.pick(x, y);
  },
  async png() {
    return drawing.png();
  },
  async run({words, names}) {
    await load();
    return drawing.run(words, names);
  },
};

let last = Promise.resolve();
self.onmessage = ({data: {id, name, values}}) => {
  last = last.then(async () => {
    try {
      const result = await calls[name](values);
      self.postMessage({id, result}, result?.pixels ? [result.pixels.buffer] : []);
    } catch (error) {
      self.postMessage({id, error: {message: error.message, status: error.status ?? 1, messages: error.messages ?? []}});
    }
  });
};
