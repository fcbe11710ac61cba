// Compares pictures of glTF files by zstrip with those by three.js in Chromium.
//   node viewer.mjs draw WORK ZSTRIP CHROMIUM MODELS   draws and measures all, in the folder WORK
//   node viewer.mjs check ASPECT WORK                  whether what differs is what expected.csv lists
//   node viewer.mjs table WORK FILE [--write]          whether FILE is the table of what differs; writes it
// Exit status: 0 yes, 1 no, 2 wrong words, 77 something is not to be had here; WORK/missing says what.
import {existsSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {fetchPackage, Missing, skip, skipMissing} from '../npm_package.mjs';

import {drawAll} from './draw.mjs';
import {kAspects, readExpected, surprises, worstOf} from './expected.mjs';
import {tableOf} from './table.mjs';

const kHere = dirname(fileURLToPath(import.meta.url));

async function draw(work, zstrip, chromium, models) {
  mkdirSync(work, {recursive: true});
  for (const name of ['missing', 'measured.json']) rmSync(join(work, name), {force: true});
  try {
    if (!existsSync(chromium)) throw new Missing('chromium is not installed');
    if (!existsSync(models)) throw new Missing('assimp-testmodels is not installed');
    const rows = await drawAll({zstrip, chromium, models, three: fetchPackage(kHere, work), work});
    writeFileSync(join(work, 'measured.json'), JSON.stringify(rows, null, 1));
    console.log(`${rows.length} comparisons`);
    return 0;
  } catch (error) {
    return skipMissing(error, work);
  }
}

function measuredIn(work) { return worstOf(JSON.parse(readFileSync(join(work, 'measured.json')))); }

function check(aspect, work) {
  const found = surprises(measuredIn(work), readExpected(join(kHere, 'expected.csv')), aspect);
  for (const line of found) console.log(line);
  if (found.length > 0) console.log(`three.js, zstrip, and red where they are apart: ${join(work, 'pairs')}`);
  return found.length > 0 ? 1 : 0;
}

function table(work, file, write) {
  const text = tableOf(measuredIn(work), readExpected(join(kHere, 'expected.csv')));
  if (write) writeFileSync(file, text);
  if (existsSync(file) && readFileSync(file, 'utf8') === text) return 0;
  console.log(`${file} is not what was measured; tests/measure viewer writes it`);
  return 1;
}

async function main([command, ...words]) {
  if (command === 'draw' && words.length === 4) return draw(...words);
  const isCheck = command === 'check' && words.length === 2 && kAspects.includes(words[0]);
  const isTable = command === 'table' && (words.length === 2 || (words.length === 3 && words[2] === '--write'));
  if (!isCheck && !isTable) {
    console.error('viewer.mjs: wrong words; its first lines say which there are');
    return 2;
  }
  const work = isCheck ? words[1] : words[0];
  if (existsSync(join(work, 'missing'))) return skip(work);
  return isCheck ? check(...words) : table(work, words[1], words.length === 3);
}

process.exitCode = await main(process.argv.slice(2));
