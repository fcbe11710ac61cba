// What the command of this machine draws and writes, to which the page is held.
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

export class Command {
  #zstrip;
  #scenes;

  /** `scenes`: the folder that names of scene files start in. */
  constructor(zstrip, scenes) {
    this.#zstrip = zstrip;
    this.#scenes = scenes;
  }

  /** The bytes of the file that `zstrip COMMAND SCENE -o NAME ...` writes. */
  writes(command, scene, name, options = []) {
    const folder = mkdtempSync(join(tmpdir(), 'zstrip-'));
    try {
      execFileSync(this.#zstrip, [command, scene, '-o', join(folder, name), '--quiet', ...options], {cwd: this.#scenes, stdio: 'pipe'});
      return readFileSync(join(folder, name));
    } finally {
      rmSync(folder, {recursive: true});
    }
  }

  /** How different the picture that `zstrip render` draws is from the truth. */
  compares(scene, options = []) {
    const folder = mkdtempSync(join(tmpdir(), 'zstrip-'));
    try {
      const words = ['render', scene, '-o', join(folder, 'a.png'), '--show', 'accuracy', '--quiet', '--json', '-', ...options];
      return JSON.parse(execFileSync(this.#zstrip, words, {cwd: this.#scenes, stdio: 'pipe'})).frames[0].accuracy;
    } finally {
      rmSync(folder, {recursive: true});
    }
  }

  /** What a pixel shows, in words. */
  picks(scene, x, y, options = []) {
    const folder = mkdtempSync(join(tmpdir(), 'zstrip-'));
    try {
      const words = ['render', scene, '-o', join(folder, 'a.png'), '--pick', `${x},${y}`, ...options];
      const summary = execFileSync(this.#zstrip, words, {cwd: this.#scenes, stdio: 'pipe', encoding: 'utf8'});
      return /^ *picked +(.*)$/m.exec(summary)[1];
    } finally {
      rmSync(folder, {recursive: true});
    }
  }

  /** {width, height, rgb}: the picture that `zstrip render` draws. */
  draws(scene, options = []) {
    const file = this.writes('render', scene, 'picture.ppm', options);
    const [header, kind, width, height] = /^(P[56])\s(\d+) (\d+)\s255\s/.exec(file.toString('latin1', 0, 40));
    const pixels = file.subarray(header.length);
    // Of greys one byte a pixel.
    const rgb = kind === 'P6' ? pixels : Buffer.from([...pixels].flatMap((grey) => [grey, grey, grey]));
    return {width: Number(width), height: Number(height), rgb};
  }
}
