// Shows a page to headless Chromium. A server on the loopback address gives it files and takes what it sends back.
import {spawn} from 'node:child_process';
import {createReadStream, existsSync, rmSync, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join, normalize} from 'node:path';

const kTypes = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm'
};

const kOptions = [
  '--headless',
  '--no-sandbox',  // it runs as root in containers, and shows no page but ours
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-extensions',
  '--disable-sync',
  '--force-color-profile=srgb',
  '--force-device-scale-factor=1',
  '--no-default-browser-check',
  '--no-first-run',
];

async function bodyOf(request) {
  const parts = [];
  for await (const part of request) parts.push(part);
  return Buffer.concat(parts);
}

function serveFile(path, response) {
  if (!existsSync(path) || !statSync(path).isFile()) {
    response.writeHead(404).end();
    return;
  }
  response.writeHead(200, {'content-type': kTypes[extname(path)] ?? 'application/octet-stream'});
  createReadStream(path).pipe(response);
}

/**
 * Opens /page/page.html. `profile`: a folder for Chromium, emptied before and after. `folders`: what lies below the
 * first part of a URL's path. `onPost(path, body, information)` is called for each POST, and the next one does not
 * wait for it; the header x-information, JSON, is what the page says of the body. Ends when the page posts to /done,
 * and fails when it posts to /failed, when Chromium ends before, or after `seconds`.
 */
export async function showPage({chromium, profile, folders, onPost, seconds}) {
  let finish;
  const finished = new Promise((resolve, reject) => (finish = {resolve, reject}));
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    if (request.method === 'POST') {
      const body = await bodyOf(request);
      response.end();
      if (path === '/done') return finish.resolve();
      if (path === '/failed') return finish.reject(new Error(`the page failed: ${body}`));
      Promise.resolve(onPost(path, body, JSON.parse(decodeURIComponent(request.headers['x-information'] ?? 'null'))))
          .catch(finish.reject);
      return;
    }
    const [, first, ...rest] = path.split('/');
    const below = normalize(rest.join('/'));
    if (!(first in folders) || below.startsWith('..')) return response.writeHead(404).end();
    serveFile(join(folders[first], below), response);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  rmSync(profile, {recursive: true, force: true});
  const browser = spawn(
      chromium,
      [...kOptions, `--user-data-dir=${profile}`, `http://127.0.0.1:${server.address().port}/page/page.html`],
      {stdio: ['ignore', 'ignore', 'pipe']},
  );
  // Chromium must not outlive a test that is ended.
  const end = () => browser.kill();
  const endAll = () => process.exit(1);
  process.once('exit', end);
  for (const signal of ['SIGINT', 'SIGTERM']) process.once(signal, endAll);
  let words = '';
  browser.stderr.on('data', (data) => (words = (words + data).slice(-4000)));
  browser.on('error', (error) => finish.reject(error));
  const ended = new Promise((resolve) => browser.on('close', resolve));
  ended.then((status) => finish.reject(new Error(`Chromium ended with ${status}: ${words}`)));
  const timer =
      setTimeout(() => finish.reject(new Error(`no end after ${seconds} seconds: ${words}`)), seconds * 1000);
  try {
    await finished;
  } finally {
    clearTimeout(timer);
    process.off('exit', end);
    for (const signal of ['SIGINT', 'SIGTERM']) process.off(signal, endAll);
    browser.kill();
    await ended;
    server.closeAllConnections();
    server.close();
    rmSync(profile, {recursive: true, force: true, maxRetries: 5, retryDelay: 200});
  }
}
