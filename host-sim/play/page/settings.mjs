// The settings: options of the command, controls of the page, and parts of a link.

// `kind`: choice, flag, text or colour; without a value the option is left out. `tip`: explains the setting. `isBaked`:
// `zstrip bake` has it, too. `isOfModels`: for models only; a scene file has it in its text. `isOfAnimations`: for models
// and baked scenes, whose animations have names. `isRare`: shown on demand.
export const kSettings = [
  {
    name: 'board', label: 'Board', option: '--board', kind: 'choice', choices: [''], none: 'none',
    tip: 'Its memory is the limit, and the frames a second below the picture are an estimate for it.'
  },
  {
    name: 'ram', label: 'RAM at most', option: '--ram', isBaked: true, kind: 'text', hint: '20K',
    tip: 'Bytes for all that the renderer keeps: less memory makes smaller strips, not another picture. 20K or 1M; max ' +
      'is the whole picture in one strip.'
  },
  {
    name: 'size', label: 'Size', option: '--size', isBaked: true, kind: 'text', hint: '240x240',
    tip: 'Width and height of the display in pixels, 240x240 or 320x240.'
  },
  {
    name: 'format', label: 'Pixels', option: '--format', isBaked: true, kind: 'choice',
    choices: ['', 'rgb565', 'rgb565_swapped', 'rgb666', 'rgb444', 'xrgb8888', 'gray4', 'mono'],
    tip: 'How a pixel is stored and sent: colour displays on SPI take rgb565_swapped, small OLEDs mono or gray4.'
  },
  {
    name: 'dither', label: 'Dithering', option: '--dither', isBaked: true, kind: 'flag',
    tip: 'A fine pattern hides the steps between the few colours of the display.'
  },
  {
    name: 'samples', label: 'Samples a pixel', option: '--samples', isBaked: true, kind: 'choice', choices: ['', '1', '2', '4'],
    tip: 'Several samples a pixel smooth all edges; each takes the time and memory of a pixel.'
  },
  {
    name: 'edges', label: 'Smooth edges', option: '--edges', isBaked: true, kind: 'flag',
    tip: 'Smooths only the outlines of models, in less time than several samples. Needs one sample a pixel.'
  },
  {
    name: 'background', label: 'Background', option: '--background', isBaked: true, isOfModels: true, kind: 'colour',
    hint: '#203040', tip: 'The colour where nothing is drawn. In a scene file it is the key background of its text.'
  },
  {
    name: 'light', label: 'Light from', option: '--light', isBaked: true, isOfModels: true, kind: 'choice',
    choices: ['', '0,1,0.2', '0,0.2,1', '-1,0.5,0.5', '1,0.5,0.5', '0,0.5,-1'],
    names: {
      '': 'above the viewer', '0,1,0.2': 'above', '0,0.2,1': 'the viewer', '-1,0.5,0.5': 'the left',
      '1,0.5,0.5': 'the right', '0,0.5,-1': 'behind'
    },
    tip: 'Where the light of a model without lights comes from. In a scene file it is the first [[light]] of its text.'
  },
  {
    name: 'animation', label: 'Animation', option: '--animation', isBaked: true, isOfAnimations: true, kind: 'text', hint: 'walk',
    tip: 'The name of an animation of a glTF file or a baked scene; files that the page writes then have this one alone.'
  },
  {
    name: 'strip-rows', label: 'Rows of a strip', option: '--strip-rows', isBaked: true, kind: 'text', hint: 'auto', isRare: true,
    tip: 'The picture is drawn strip by strip; auto is as many rows as fit into the memory.'
  },
  {
    name: 'depth-format', label: 'Depth', option: '--depth-format', kind: 'choice', choices: ['', 'z16', 'float', 'z24'], isRare: true,
    tip: 'How the distance of a pixel is stored: z16 is the fastest; float and z24 tell far surfaces apart.'
  },
  {
    name: 'perspective', label: 'Textures exact every', option: '--perspective', kind: 'choice', choices: ['', '1', '8', '16', 'affine'],
    isRare: true, tip: 'Pixels from one exact texel to the next, linear between them; affine: only at corners of triangles.'
  },
  {
    name: 'panel', label: 'Panel', option: '--panel', kind: 'choice', isRare: true,
    choices: ['', 'st7789', 'ili9341', 'st7735', 'gc9a01', 'st7796', 'ili9342', 'ili9488', 'co5300', 'sh8601', 'st77916', 'ssd1351', 'ssd1306', 'ssd0323',
      'ssd1680'],
    none: 'none: the pixels alone',
    tip: 'The driver sends the picture to a model of this controller; it is shown as its glass would be.'
  },
  {
    name: 'rotation', label: 'Rotated on the panel', option: '--rotation', kind: 'choice', choices: ['', '90', '180', '270'], none: '0',
    isRare: true, tip: 'How the panel is mounted, in degrees clockwise. Needs a panel.'
  },
  {
    name: 'frames', label: 'Frames', option: '--frames', kind: 'text', hint: '64', isRare: true,
    tip: 'Frames of the animation, or of a full rotation of a scene without one.'
  },
];

// Ways to look at a scene, in the order of zstrip_look. To change it, the scene need not be read again.
export const kLooks = ['colours', 'wireframe', 'depth', 'overdraw', 'accuracy'];
export const kStartView = {look: 0, slow: 0, frame: 0, yaw: 0, pitch: 0, zoom: 0};
const kStart = {scene: 'gallery/lighthouse.toml', ram: '22K', board: 'pico'};

// The file for a Pico that has the program that shows it, too, and that program's file by the board's name.
const kBoth = 'both.uf2';
export const kPicoPrograms = {pico: 'zstrip_pico_player.uf2', pico2: 'zstrip_pico2_player.uf2'};

const isDigitsOf = (value) => /^-?[0-9]+(\.[0-9]+)?$/.test(value);

// Tells scenes apart by their names, as the command does.
export const isText = (scene) => /\.toml$/i.test(scene);
export const isModel = (scene) => scene.includes('.') && !/\.(toml|zsc)$/i.test(scene);
export const hasAnimations = (scene) => isModel(scene) || /\.zsc$/i.test(scene);

// The options of `zstrip view`; with `command` 'bake' those that `zstrip bake` has.
export function optionsOf(settings, command = 'view') {
  const options = [];
  for (const {name, option, kind, isBaked, isOfModels, isOfAnimations} of kSettings) {
    const value = settings[name];
    if (!value || (command === 'bake' && !isBaked) || (isOfModels && !isModel(settings.scene))) continue;
    if (isOfAnimations && !hasAnimations(settings.scene)) continue;
    if (kind === 'flag') {
      options.push(value === 'no' ? option.replace('--', '--no-') : option);
    } else {
      options.push(option, value);
    }
  }
  return options;
}

// The words after `zstrip` that write the file `name`; `pico`: the board that a .uf2 file is for. Its panel and memory are
// the command's own, not settings.
export function bakeWordsOf(settings, name, pico = 'pico') {
  const words = ['bake', settings.scene, '-o', name];
  if (!name.endsWith('.uf2')) return [...words, '--turntable', ...optionsOf(settings, 'bake')];
  if (pico !== 'pico') words.push('--board', pico);
  if (name === kBoth) words.push('--with', kPicoPrograms[pico]);
  return [...words, ...optionsOf({...settings, size: '', format: '', ram: '', 'strip-rows': ''}, 'bake')];
}

// The words after `zstrip` that write all frames as one picture that moves.
export const turnWordsOf = (settings, name, frames) =>
  ['render', settings.scene, '-o', name, ...optionsOf({...settings, board: '', frames: String(frames)})];

// Returns the command line for a shell, with quotes where they are needed.
export function commandLineOf(words) {
  return ['zstrip', ...words].map((word) => (/^[\w.,:=+/-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`)).join(' ');
}

// Returns the part of a link after its #. `view.frame` undefined: the frames play. `files`: packed, or undefined.
export function linkOf(settings, view, files) {
  const pairs = [['scene', settings.scene ?? '']];
  for (const {name} of kSettings) {
    if (settings[name]) pairs.push([name, settings[name]]);
  }
  for (const [name, start] of Object.entries(kStartView)) {
    if (view[name] === undefined || (view[name] === start && name !== 'frame')) continue;
    pairs.push([name, String(Math.round(view[name] * 100) / 100)]);
  }
  if (files) pairs.push(['files', files]);
  return '#' + new URLSearchParams(pairs);
}

// Unknown settings of a link are left out; the command checks the values. A link without a scene opens the first scene.
export function settingsOf(link) {
  const given = new URLSearchParams(link.replace(/^#/, ''));
  const settings = given.get('scene') ? {scene: given.get('scene')} : {...kStart};
  const view = {...kStartView};
  for (const {name} of kSettings) {
    if (given.has(name)) settings[name] = given.get(name);
  }
  for (const name of Object.keys(view)) {
    const value = given.get(name);
    if (value !== null && isDigitsOf(value)) view[name] = Number(value);
  }
  if (!(view.look in kLooks)) view.look = 0;
  view.frame = Math.max(0, Math.floor(view.frame));
  return {settings, view, plays: !given.has('frame'), files: given.get('files') ?? undefined};
}
