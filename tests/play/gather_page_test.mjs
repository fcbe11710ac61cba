// The page has the programs for the Picos that it is told of, or says which it does not have.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';

const kGather = join(dirname(fileURLToPath(import.meta.url)), '../../host-sim/play/gather_page.mjs');
const work = mkdtempSync(join(tmpdir(), 'gather-page-'));
after(() => rmSync(work, {recursive: true}));

const program = join(work, 'some.uf2'), missing = join(work, 'missing.uf2'), page = join(work, 'page');
writeFileSync(program, 'a program');
const gather = (environment, ...modules) =>
  spawnSync(process.execPath, [kGather, page, ...modules], {encoding: 'utf8', env: {...process.env, ...environment}});

test('programs that are named are on the page', () => {
  const {status, stdout, stderr} = gather({ZSTRIP_PICO_PROGRAM: program, ZSTRIP_PICO2_PROGRAM: program});
  assert.deepEqual([status, stdout, stderr], [0, '', '']);
  assert.deepEqual(JSON.parse(readFileSync(join(page, 'contents.json'))).programs, ['pico', 'pico2']);
  for (const name of ['zstrip_pico_player.uf2', 'zstrip_pico2_player.uf2'])
    assert.equal(readFileSync(join(page, name), 'utf8'), 'a program');
});

function leavesThePage(environment, complaint, ...modules) {
  mkdirSync(page, {recursive: true});
  writeFileSync(join(page, 'before'), '');
  const named = {ZSTRIP_PICO_PROGRAM: program, ZSTRIP_PICO2_PROGRAM: program, ...environment};
  const {status, stderr} = gather(named, ...modules);
  assert.deepEqual([status, stderr], [1, `zstrip: ${complaint}\n`]);
  assert.ok(existsSync(join(page, 'before')));
}

for (const variable of ['ZSTRIP_PICO_PROGRAM', 'ZSTRIP_PICO2_PROGRAM']) {
  test(`${variable} that is not there is an error, and the page stays as it was`, () => {
    leavesThePage({[variable]: missing}, `${variable}: there is no file '${missing}'`);
  });
  test(`${variable} that is a folder is an error, and the page stays as it was`, () => {
    leavesThePage({[variable]: work}, `${variable}: there is no file '${work}'`);
  });
}

test('a module that is not there is an error, and the page stays as it was', () => {
  leavesThePage({}, `there is no module '${missing}'`, program, missing);
});

test('what the build tree does not have is said', () => {
  const {status, stdout} = gather({ZSTRIP_PICO_PROGRAM: '', ZSTRIP_PICO2_PROGRAM: program});
  assert.equal(status, 0);
  const has = JSON.parse(readFileSync(join(page, 'contents.json'))).programs.includes('pico');
  assert.equal(stdout.includes('the page is without zstrip_pico_player.uf2'), !has);
});
