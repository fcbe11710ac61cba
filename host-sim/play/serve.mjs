// Serves a folder to this machine alone:
//     node serve.mjs FOLDER [PORT]
import {createReadStream, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join, normalize} from 'node:path';
import {fileURLToPath} from 'node:url';

const kTypes = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css',
  '.mjs': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
};

/** The server, which listens; a port of 0 is any. */
export function serve(folder, port = 0) {
  const server = createServer((request, response) => {
    let path;
    try {
      path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
    } catch {
      return response.writeHead(400).end('no address\n');
    }
    if (path.endsWith('/')) path += 'index.html';
    const file = join(folder, path);
    if (!statSync(file, {throwIfNoEntry: false})?.isFile()) return response.writeHead(404).end('not here\n');
    response.writeHead(200, {'content-type': kTypes[extname(file)] ?? 'application/octet-stream'});
    createReadStream(file).pipe(response);
  });
  return new Promise((resolve, reject) => {
    server.on('error', reject);
    server.listen(port, '127.0.0.1', () => resolve(server));
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder, port = '8080'] = process.argv.slice(2);
  try {
    await serve(folder, Number(port));
    console.log(`http://localhost:${port}/ shows the playground; Ctrl-C ends it`);
  } catch (error) {
    console.error(`zstrip: port ${port}: ${error.message}`);
    process.exit(3);
  }
}
