// run.mjs PROGRAM: runs a program of this folder under Node.js; its console is standard output, its status the exit
// status. A trap is an exception, which Node.js reports.
import { readFileSync, writeSync } from 'node:fs';

const [program] = process.argv.slice(2);
if (program === undefined) {
  console.error('usage: node run.mjs PROGRAM');
  process.exit(2);
}

let text = [];
const flush = () => {
  for (let bytes = Buffer.from(text); bytes.length > 0;) bytes = bytes.subarray(writeSync(1, bytes));
  text = [];
};
const put_character = (character) => {
  text.push(character);
  if (character === 0x0a) flush();
};

const { instance } = await WebAssembly.instantiate(readFileSync(program), { zstrip: { put_character } });
process.exitCode = instance.exports.run();
flush();
