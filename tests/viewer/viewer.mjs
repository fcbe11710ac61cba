// Compares pictures of glTF files by zstrip with those by three.js in Chromium.
//   node viewer.mjs draw WORK ZSTRIP CHROMIUM MODELS   draws and measures all, in the folder WORK
//   node viewer.mjs check ASPECT WORK                  whether what differs is what expected.csv lists
//   node viewer.mjs table WORK FILE [--write]          whether FILE is the table of what differs; writes it
// Exit status: 0 yes, 1 no, 2 wrong words, 77 something is not to be had here; WORK/missing says what.
import {execFileSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {drawAll} from './draw.mjs';
import {kAspects, readExpected, surprises, worstOf} from './expected.mjs';
import {tableOf} from './table.mjs';

const kHere = dirname(fileURLToPath(import.meta.url));
const kSkipped = 77;

class Missing extends Error {}

/** The folder of three.js of the pinned version, which npm fetches once. */
function fetchThree(work) {
  const wanted = JSON.parse(readFileSync(join(kHere, 'package.json'))).dependencies.three;
  const folder = join(work, 'node_modules', 'three');
  const there = join(folder, 'package.json');
  if (existsSync(there) && JSON.parse(readFileSync(there)).version === wanted) return folder;
  for (const name of ['package.json', 'package-lock.json']) copyFileSync(join(kHere, name), join(work, name));
  const words = ['ci', '--ignore-scripts', '--no-audit', '--no-fund', '--fetch-retries=1', '--fetch-timeout=30000'];
  try {
    execFileSync('npm', words, {cwd: work, stdio: ['ignore', 'ignore', 'pipe'], timeout: 120000});
  } catch (error) {
    if (error.code === 'ENOENT') throw new Missing('npm is not installed');
    throw new Missing(
        `npm cannot fetch three ${wanted}: ${String(error.stderr || error.message).trim().split('\n')[0]}`);
  }
  return folder;
}

async function draw(work, zstrip, chromium, models) {
  mkdirSync(work, {recursive: true});
  for (const name of ['missing', 'measured.json']) rmSync(join(work, name), {force: true});
  try {
    if (!existsSync(chromium)) throw new Missing('chromium is not installed');
    if (!existsSync(models)) throw new Missing('assimp-testmodels is not installed');
    const rows = await drawAll({zstrip, chromium, models, three: fetchThree(work), work});
    writeFileSync(join(work, 'measured.json'), JSON.stringify(rows, null, 1));
    console.log(`${rows.length} comparisons`);
    return 0;
  } catch (error) {
    if (!(error instanceof Missing)) throw error;
    writeFileSync(join(work, 'missing'), error.message);
    return skip(work);
  }
}

function skip(work) {
  console.log(`skipped: ${readFileSync(join(work, 'missing'), 'utf8')}`);
  return kSkipped;
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
