// The page has the programs for the Picos that it is told of, or says which it does not have; what its build lacks is named.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';

const kRoot = join(dirname(fileURLToPath(import.meta.url)), '../..');
const kGather = join(kRoot, 'host-sim/play/gather_page.mjs');
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

// On a machine that has the programs and headers of these names alone.
function build(programs, headers, name = 'built') {
  const machine = mkdtempSync(join(work, 'machine-'));
  mkdirSync(join(machine, 'bin'));
  mkdirSync(join(machine, 'include'));
  for (const program of ['bash', 'env', 'dirname', 'readlink', ...programs]) {
    symlinkSync(spawnSync('which', [program], {encoding: 'utf8'}).stdout.trim() || process.execPath, join(machine, 'bin', program));
  }
  for (const header of headers) mkdirSync(join(machine, 'include', header));
  return spawnSync(join(kRoot, 'host-sim/play/build'), [join(machine, name)],
    {encoding: 'utf8', env: {PATH: join(machine, 'bin'), ZSTRIP_HEADERS: join(machine, 'include')}});
}

const kPrograms = ['emcmake', 'wasm-opt', 'terser', 'cmake', 'ninja', 'node'];
const kHeaders = ['CLI', 'nlohmann', 'stb', 'toml++', 'utf8cpp'];

test('what the build lacks is named by the packages that have it', () => {
  const {status, stderr} = build([], []);
  assert.equal(status, 3);
  const named = stderr.split('--no-install-recommends ')[1].trim().split(' ');
  const known = readFileSync(join(kRoot, 'cmake/zstrip_packages.txt'), 'utf8');
  assert.equal(named.length, kPrograms.length + 1 + kHeaders.length);  // programs, acorn, headers
  for (const name of named) assert.match(known, new RegExp(`^(host|play) +${name}$`, 'm'));
});

test('one missing header is named, and nothing of the build tool is said', () => {
  const {status, stderr} = build(kPrograms, kHeaders.slice(0, -1));
  assert.equal(status, 3);
  assert.match(stderr, /--no-install-recommends (node-acorn )?libutfcpp-dev\n$/);
  assert.doesNotMatch(stderr, /CMake/);
});
