// The text of a scene file: the values that the page's controls read and replace, and the line of an error.

const kBackground = /^([ \t]*background[ \t]*=[ \t]*)("[^"\n]*"|'[^'\n]*'|\[[^\]]*\])/m;
const kTable = /^[ \t]*\[/m;

// The keys above the first table, and the rest.
function halves(text) {
  const at = text.search(kTable);
  return at < 0 ? [text, ''] : [text.slice(0, at), text.slice(at)];
}

const hexadecimal = (channel) => Number(channel).toString(16).padStart(2, '0');

/** The background as #rrggbb; undefined if the text names none. */
export function backgroundOf(text) {
  const value = kBackground.exec(halves(text)[0])?.[2];
  if (!value) return undefined;
  const digits = /^["']#?([0-9a-f]{6})["']$/i.exec(value)?.[1];
  if (digits) return `#${digits.toLowerCase()}`;
  const channels = value.match(/\d+/g);
  return channels?.length === 3 && channels.every((each) => each < 256) ? `#${channels.map(hexadecimal).join('')}` : undefined;
}

export function withBackground(text, colour) {
  const [keys, tables] = halves(text);
  if (kBackground.test(keys)) return keys.replace(kBackground, `$1"${colour}"`) + tables;
  const comments = /^(?:[ \t]*#[^\n]*\n)*/.exec(keys)[0];
  return `${comments}background = "${colour}"\n${keys.slice(comments.length)}${tables}`;
}

/** The first [[light]] that has a direction shines from there, or a new one. `from`: X,Y,Z. */
export function withLight(text, from) {
  const direction = `direction = [${from.split(',').map((each) => -Number(each) || 0).join(', ')}]`;
  const tables = text.split(/^(?=[ \t]*\[)/m);
  const kDirection = /^([ \t]*)direction[ \t]*=[ \t]*\[[^\]]*\]/m;
  const at = tables.findIndex((table) => /^[ \t]*\[\[[ \t]*light[ \t]*\]\]/.test(table) && kDirection.test(table));
  if (at < 0) return `${text.replace(/\n*$/, '\n')}\n[[light]]\n${direction}\n`;
  tables[at] = tables[at].replace(kDirection, `$1${direction}`);
  return tables.join('');
}

/** A scene file beside the model of this path, with the light and the background that a model has alone. */
export const sceneFileOf = (path) => `# ${JSON.stringify(path).slice(1, -1)}, seen from the front; a [camera] shows it from elsewhere.
background = "#ced3d6"
ambient = [104, 104, 104]

[[light]]
direction = [-0.1, -0.8, -0.6]
colour = "#979797"

[[model]]
name = "model"
file = ${JSON.stringify(path.split('/').at(-1))}

[[instance]]
model = "model"
`;

/** {line, words} of a message about the file of this path; undefined if it names no line of it. */
export function lineOfError(message, path) {
  const [, file, line, words] = /^'([^']*)' line (\d+): ([^]*)$/.exec(message) ?? [];
  return file === path ? {line: Number(line), words} : undefined;
}
