// Serves the files of a folder to this machine alone:
//     node serve.mjs FOLDER [PORT]
// Any page that is open in a browser here can send requests, so it only reads files of the folder, and no request ends
// it.
import {constants, realpathSync} from 'node:fs';
import {open, realpath} from 'node:fs/promises';
import {createServer} from 'node:http';
import {extname, join, sep} from 'node:path';
import {pipeline} from 'node:stream/promises';
import {fileURLToPath} from 'node:url';

const kTypes = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css',
  '.mjs': 'text/javascript',
  '.json': 'application/json',
  '.png': 'image/png',
  '.wasm': 'application/wasm',
};
// A name that leads here by the DNS of others is refused. The port may be that of a tunnel.
const kLoopback = /^(localhost|127\.0\.0\.1|\[::1\])(:[0-9]+)?$/i;
const kNotThere = ['ENOENT', 'ENOTDIR', 'ELOOP', 'ENAMETOOLONG', 'EACCES'];

class Refused extends Error {
  constructor(status, message, headers = {}) {
    super(message);
    Object.assign(this, {status, headers});
  }
}

/** The path that a request asks for, below the folder. */
function pathOf({method, headers: {host}, url}) {
  if (!kLoopback.test(host ?? '')) throw new Refused(421, 'this server is asked by the name localhost');
  if (method !== 'GET' && method !== 'HEAD') throw new Refused(405, 'files are only read', {allow: 'GET, HEAD'});
  let path;
  try {
    path = decodeURIComponent(url.split('?')[0]);
  } catch {
    throw new Refused(400, 'the address is not encoded as UTF-8');
  }
  if (!path.startsWith('/') || path.includes('\0')) throw new Refused(400, 'the address is no path');
  return path.endsWith('/') ? `${path}index.html` : path;
}

/** The open file at `path` with its size; links are followed inside the folder `root` alone. */
async function openFile(root, path) {
  const real = await realpath(join(root, path));
  if (!real.startsWith(root + sep)) throw new Refused(404, 'not here');
  const file = await open(real, constants.O_RDONLY | constants.O_NONBLOCK);  // a pipe without a writer would wait
  const found = await file.stat();
  if (found.isFile()) return {file, size: found.size};
  await file.close();
  throw new Refused(404, 'not here');
}

async function answer(root, request, response) {
  const path = pathOf(request);
  const {file, size} = await openFile(root, path);
  response.writeHead(200, {'content-type': kTypes[extname(path)] ?? 'application/octet-stream', 'content-length': size});
  if (request.method === 'GET' && size > 0) return pipeline(file.createReadStream({end: size - 1}), response);
  response.end();
  await file.close();
}

function refuse(error, response) {
  if (response.headersSent) return response.destroy();  // the download was given up, or its file cannot be read
  const {status, message, headers} = error instanceof Refused ? error :
    kNotThere.includes(error.code) ? new Refused(404, 'not here') : new Refused(500, 'the file cannot be read');
  response.writeHead(status, {'content-type': 'text/plain', ...headers}).end(`${message}\n`);
}

/** The server, which listens; a port of 0 is any. */
export async function serve(folder, port = 0) {
  const root = realpathSync(folder);
  const server = createServer((request, response) =>
    answer(root, request, response).catch((error) => refuse(error, response)));
  return new Promise((resolve, reject) => {
    server.on('error', reject);
    server.listen(port, '127.0.0.1', () => resolve(server));
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder, port = '8080'] = process.argv.slice(2);
  try {
    const server = await serve(folder, Number(port));
    console.log(`http://localhost:${server.address().port}/ shows the playground; Ctrl-C ends it`);
  } catch (error) {
    const reasons = {
      EADDRINUSE: `port ${port} is taken by another program; name another one`,
      EACCES: `port ${port} is not for users; name one from 1024`,
      ERR_SOCKET_BAD_PORT: `'${port}' is no port; one is a number up to 65535`,
      ENOENT: `there is no folder '${folder}'`,
    };
    console.error(`zstrip: ${reasons[error.code] ?? error.message}`);
    process.exit(3);
  }
}
