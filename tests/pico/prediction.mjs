// What `zstrip bench --board pico` predicts, held against the emulator: the benchmark's own program runs in it, with
// equal strips, so that instructions are as many, and cycles and misses of the flash's cache can be compared.
import {spawnSync} from 'node:child_process';
import {dirname} from 'node:path';

import {readElf} from './elf.mjs';
import {Mps2} from './mps2.mjs';

const kWorkloads = ['K5M', 'CT'], kFrames = 2;
const kCyclesWithin = 1e-4, kMissesWithin = 0.01;

/** The command's predictions; nothing where QEMU or its plugins are not to be had. */
function predictions(zstrip, firmware) {
  const words = ['bench', '--board', 'pico', '--workload', kWorkloads.join(), '--frames', `${kFrames}`, '--firmware',
    firmware, '--json', '-'];
  const {status, stdout, stderr} = spawnSync(zstrip, words, {encoding: 'utf8'});
  if (status === 3) return console.log(`skipped: ${stderr}`);
  if (status !== 0) throw new Error(`zstrip ${words.join(' ')}: ${stderr}`);
  return JSON.parse(stdout);
}

/** Prints each, and returns what is wrong; nothing where it cannot be found out. */
export function wrongPredictions(library, elf, zstrip) {
  const program = readElf(elf);
  return predictions(zstrip, dirname(elf))?.flatMap((predicted) => {
    const {workload, config, assumptions} = predicted;
    const board = new Mps2(library, program, `workload=${workload} size=${config.width}x${config.height} ` +
        `frames=${kFrames} rows=${config.strip_rows} buffers=2`);
    board.run();
    if (board.status !== 0) return [`${workload}: ${board.status}, ${board.console}`];
    const wrong = [], [cycles] = predicted.core_cycles_per_frame;
    const compare = (what, expected, counted, within) => {
      const line = `${workload}: ${expected} ${what} a frame predicted, ${counted} in the emulator`;
      console.log(`${line}, ${((counted / expected - 1) * 100).toFixed(2)} %`);
      if (!(Math.abs(counted - expected) <= within * counted)) wrong.push(`more than ${within * 100} %: ${line}`);
    };
    const {counted} = board;
    compare('instructions', predicted.instructions_per_frame, counted.instructions / kFrames, 0);
    compare('cycles', cycles, counted.cycles / kFrames, kCyclesWithin);
    const misses = predicted.flash_cycles_per_frame[0] / assumptions.wait_states;
    compare('misses', misses, counted.misses / kFrames, kMissesWithin);
    return wrong;
  });
}
