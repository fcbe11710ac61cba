// The command and the viewer in WebAssembly, for a worker of the page or for Node.js. Errors are thrown, in words.

// Folders of the files of user and examples, and of the files that commands write.
const kScenes = '/scenes';
const kOutput = '/output';

export class SceneError extends Error {
  // `status`: the exit status that `zstrip` would have. `messages`: the other lines that it would print.
  constructor(message, status, messages) {
    super(message);
    this.status = status;
    this.messages = messages;
  }
}

export class Drawing {
  #create;
  #module;
  #messages = [];
  #output = [];
  #files = new Map();

  // `create`: the function that zstrip.mjs exports; `options`: options for it. After a trap it makes a new module.
  static async load(create, options = {}) {
    const drawing = new Drawing();
    drawing.#create = (own) => create({...options, ...own});
    await drawing.#start();
    return drawing;
  }

  async #start() {
    this.#module = await this.#create({
      print: (line) => this.#output.push(line),
      printErr: (line) => this.#messages.push(line.replace(/^zstrip: /, '')),
    });
    const {FS} = this.#module;
    for (const folder of [kScenes, kOutput]) FS.mkdir(folder);
    FS.chdir(kScenes);
    for (const [path, bytes] of this.#files) this.#write(path, bytes);
  }

  #write(path, bytes) {
    const {FS} = this.#module;
    const folder = path.split('/').slice(0, -1).join('/');
    if (folder) FS.mkdirTree(`${kScenes}/${folder}`);
    FS.writeFile(`${kScenes}/${path}`, bytes);
  }

  // Adds files by their relative paths. A file with the same path is replaced.
  addFiles(files) {
    for (const {path, bytes} of files) {
      const inside = path.split('/').filter((part) => part !== '' && part !== '.' && part !== '..').join('/');
      this.#files.set(inside, bytes);
      this.#write(inside, bytes);
    }
  }

  // Runs `act`; a trap, which leaves memory as it happened to be, ends with a new start.
  async #guarded(act) {
    this.#messages = [];
    this.#output = [];
    try {
      return act(this.#module);
    } catch (error) {
      if (error instanceof SceneError) throw error;
      const messages = this.#messages;
      await this.#start();
      const said = messages.find((line) => line.includes('crashed')) ?? 'the scene cannot be drawn here: is there too little memory?';
      throw new SceneError(`${said} (${error.message ?? error})`, 1, messages);
    }
  }

  #answer(json) {
    const answer = JSON.parse(json);
    if ('error' in answer) throw new SceneError(answer.error, answer.status, this.#messages);
    return {...answer, messages: this.#messages};
  }

  // Reads the scene. `options`: those of `zstrip view`.
  async open(scene, options) {
    const words = [scene, ...options].join('\n');
    return this.#guarded((module) => this.#answer(module.ccall('zstrip_open', 'string', ['string'], [words])));
  }

  // Draws a frame of the open scene: its figures, and four bytes for each pixel.
  async draw({look = 0, frame = 0, yaw = 0, pitch = 0, zoom = 0} = {}, shown = 0) {
    return this.#guarded((module) => {
      module._zstrip_reset_camera();
      module._zstrip_turn(yaw, pitch);
      module._zstrip_zoom(zoom);
      module._zstrip_look(look);
      module._zstrip_step(frame - shown);
      const figures = this.#answer(module.ccall('zstrip_draw', 'string', [], []));
      const begin = module._zstrip_pixels();
      return {figures, pixels: module.HEAPU8.slice(begin, begin + 4 * figures.width * figures.height)};
    });
  }

  // Names what a pixel of that frame shows, in the words of `zstrip view`.
  async pick(x, y) {
    return this.#guarded((module) =>
      this.#answer(module.ccall('zstrip_pick', 'string', ['number', 'number'], [x, y])).words);
  }

  // The frame that was drawn last as a file: byte for byte that of `zstrip render`.
  png() {
    const module = this.#module;
    const length = module._zstrip_png_bytes();
    const begin = module._zstrip_png();
    return module.HEAPU8.slice(begin, begin + length);
  }

  // The command with these arguments, of which `names` are files that it writes.
  async run(words, names = []) {
    return this.#guarded((module) => {
      const at = words.map((word) => (names.includes(word) ? `${kOutput}/${word}` : word));
      const status = module.callMain(at);
      if (status !== 0) throw new SceneError(this.#messages.at(-1) ?? `zstrip ended with ${status}`, status, this.#messages);
      const files = names.map((name) => {
        const path = `${kOutput}/${name}`;
        module.FS.chmod(path, 0o600);  // Emscripten's umask() says that nothing may be read
        const bytes = module.FS.readFile(path);
        module.FS.unlink(path);
        return {name, bytes};
      });
      return {files, output: this.#output.join('\n'), messages: this.#messages};
    });
  }
}
