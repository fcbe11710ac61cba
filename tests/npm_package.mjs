// A package of Node.js that tests need, fetched by npm once, in the version that is pinned.
import {execFileSync} from 'node:child_process';
import {copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

/** Something is not to be had on this machine. */
export class Missing extends Error {}

/** The folder, below `work`, of the one package that package.json and package-lock.json in `from` name. */
export function fetchPackage(from, work) {
  const [[name, wanted]] = Object.entries(JSON.parse(readFileSync(join(from, 'package.json'))).dependencies);
  const folder = join(work, 'node_modules', name);
  const there = join(folder, 'package.json');
  if (existsSync(there) && JSON.parse(readFileSync(there)).version === wanted) return folder;
  mkdirSync(work, {recursive: true});
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(join(from, file), join(work, file));
  const words = ['ci', '--ignore-scripts', '--no-audit', '--no-fund', '--fetch-retries=1', '--fetch-timeout=30000'];
  try {
    execFileSync('npm', words, {cwd: work, stdio: ['ignore', 'ignore', 'pipe'], timeout: 120000});
  } catch (error) {
    if (error.code === 'ENOENT') throw new Missing('npm is not installed');
    throw new Missing(
        `npm cannot fetch ${name} ${wanted}: ${String(error.stderr || error.message).trim().split('\n')[0]}`);
  }
  return folder;
}

/** ctest's status of a test that is skipped, and why it is, as skipMissing has kept it in `work`. */
const kSkipped = 77;
export function skip(work) {
  console.log(`skipped: ${readFileSync(join(work, 'missing'), 'utf8')}`);
  return kSkipped;
}

/** For this test and those after it. Errors that are not of Missing are thrown again. */
export function skipMissing(error, work) {
  if (!(error instanceof Missing)) throw error;
  writeFileSync(join(work, 'missing'), error.message);
  return skip(work);
}
