// The server of the playground, which any page in the same browser can send requests to, by requests byte for byte.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {mkdirSync, mkdtempSync, readdirSync, readlinkSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {connect} from 'node:net';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, before, test} from 'node:test';
import {fileURLToPath} from 'node:url';

const kServe = join(dirname(fileURLToPath(import.meta.url)), '../../host-sim/play/serve.mjs');
const work = mkdtempSync(join(tmpdir(), 'serve-')), folder = join(work, 'page');
let server, port;

before(async () => {
  mkdirSync(join(folder, 'inside'), {recursive: true});
  writeFileSync(join(folder, 'index.html'), '<p>the page');
  writeFileSync(join(folder, 'inside/a b.wasm'), 'a module');
  writeFileSync(join(folder, 'empty.json'), '');
  writeFileSync(join(folder, 'large.bin'), Buffer.alloc(16 << 20));
  writeFileSync(join(work, 'secret'), 'a secret');
  mkdirSync(join(work, 'page-of-others'));
  writeFileSync(join(work, 'page-of-others/secret'), 'a secret');
  symlinkSync('index.html', join(folder, 'link'));
  symlinkSync(join(work, 'secret'), join(folder, 'out'));
  symlinkSync(join(work, 'page-of-others'), join(folder, 'others'));
  symlinkSync('loop', join(folder, 'loop'));
  execFileSync('mkfifo', [join(folder, 'pipe')]);
  server = await (await import(kServe)).serve(folder);
  port = server.address().port;
});
after(() => {
  server.closeAllConnections();
  server.close();
  rmSync(work, {recursive: true});
});

const ask = (path, {method = 'GET', host = `localhost:${port}`} = {}) => new Promise((resolve, reject) => {
  const socket = connect(port, '127.0.0.1');
  let text = '';
  socket.setTimeout(10000, () => socket.destroy(new Error(`${path}: no answer`)));
  socket.on('data', (data) => text += data.toString('latin1')).on('error', reject);
  socket.on('end', () => resolve({
    status: Number(text.split(' ')[1]),
    headers: text.slice(0, text.indexOf('\r\n\r\n')).toLowerCase(),
    body: text.slice(text.indexOf('\r\n\r\n') + 4)
  }));
  socket.write(`${method} ${path} HTTP/1.1\r\n${host === null ? '' : `Host: ${host}\r\n`}Connection: close\r\n\r\n`);
});

async function serves() {
  const {status, body} = await ask('/');
  assert.deepEqual([status, body], [200, '<p>the page']);
}

test('files of the folder are served with their type and length', async () => {
  await serves();
  const {headers, body} = await ask('/inside/a%20b.wasm?query');
  assert.equal(body, 'a module');
  assert.match(headers, /content-type: application\/wasm/);
  assert.match(headers, /content-length: 8/);
  assert.equal((await ask('/link')).body, '<p>the page');
  const empty = await ask('/empty.json');
  assert.deepEqual([empty.status, empty.body], [200, '']);
});

for (const [path, expected] of [
  ['/%00', 400], ['/index.html%00.png', 400], ['/%', 400], ['/%ff', 400], ['http://localhost/index.html', 400], ['*', 400],
  ['/index.html/', 404], ['/index.html/x', 404], [`/${'a'.repeat(300)}`, 404], [`/${'a/'.repeat(3000)}`, 404], ['/loop', 404],
  ['/loop/x', 404], ['/inside', 404], ['/pipe', 404], ['/nothing', 404], ['/out', 404], ['/others/secret', 404],
  ['/../secret', 404], ['/%2e%2e/secret', 404], ['/..%2fsecret', 404], ['/inside/../../page-of-others/secret', 404],
  ['//localhost/../../secret', 404], ['/\\..\\secret', 404],
]) {
  test(`${path.slice(0, 40)} is answered by ${expected}, and the page is still there`, async () => {
    const {status, body} = await ask(path);
    assert.equal(status, expected);
    assert.doesNotMatch(body, /secret/);
    await serves();
  });
}

test('nothing but GET and HEAD is taken', async () => {
  for (const method of ['POST', 'PUT', 'DELETE', 'OPTIONS', 'PATCH', 'TRACE', 'PROPFIND']) {
    const {status, headers, body} = await ask('/', {method});
    assert.equal(status, 405, method);
    assert.match(headers, /allow: get, head/);
    assert.doesNotMatch(body, /the page/);
  }
  const {status, headers, body} = await ask('/', {method: 'HEAD'});
  assert.deepEqual([status, body], [200, '']);
  assert.match(headers, /content-length: 11/);
});

test('only names of this machine reach the page, so that no other site reads it by a name of its own', async () => {
  for (const host of ['localhost', `127.0.0.1:${port}`, `[::1]:${port}`, 'LOCALHOST:9000']) {
    assert.equal((await ask('/', {host})).status, 200, host);
  }
  for (const host of [
    'example.org', `example.org:${port}`, `localhost.example.org:${port}`, 'localhost:', 'localhost:8080@example.org', '0.0.0.0',
    `127.0.0.1.example.org:${port}`, ''
  ]) {
    const {status, body} = await ask('/', {host});
    assert.equal(status, 421, host);
    assert.doesNotMatch(body, /the page/);
  }
  assert.equal((await ask('/', {host: null})).status, 400);
  assert.equal(server.address().address, '127.0.0.1');
});

const openFiles = () => readdirSync('/proc/self/fd').filter((name) => {
  try {
    return readlinkSync(`/proc/self/fd/${name}`).startsWith(folder);
  } catch {
    return false;  // closed meanwhile
  }
}).length;

test('a download that is given up leaves no file open', async () => {
  for (let i = 0; i < 30; ++i) {
    await new Promise((resolve, reject) => {
      const socket = connect(port, '127.0.0.1');
      socket.on('error', reject).once('data', () => socket.destroy()).on('close', resolve);
      socket.write(`GET /large.bin HTTP/1.1\r\nHost: localhost\r\n\r\n`);
    });
  }
  await ask('/', {method: 'HEAD'});
  for (let i = 0; i < 500 && openFiles() > 0; ++i) await new Promise((resolve) => setTimeout(resolve, 20));
  assert.equal(openFiles(), 0);
  await serves();
});

test('a port or a folder that cannot be served is said in words', () => {
  const said = (...words) => spawnSync(process.execPath, [kServe, ...words], {encoding: 'utf8'});
  for (const [words, complaint] of [
    [[folder, String(port)], `port ${port} is taken by another program; name another one`],
    [[folder, '80x'], `'80x' is no port; one is a number up to 65535`],
    [[join(work, 'nowhere')], `there is no folder '${join(work, 'nowhere')}'`],
  ]) {
    const {status, stderr} = said(...words);
    assert.deepEqual([status, stderr], [3, `zstrip: ${complaint}\n`]);
  }
});
