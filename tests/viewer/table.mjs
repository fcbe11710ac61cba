// The page of what was compared with the other viewer, and why it differs.
import {differs, kAspects} from './expected.mjs';

const kHead = [
  'Written by `tests/measure viewer`. The files of Debian\'s package assimp-testmodels, files that Blender has exported',
  '(`tests/viewer/blender/make.py`) and files of one feature each, drawn by `zstrip render` and by three.js in Chromium',
  'with the same cameras. A test fails where they differ and this page does not say so, and where it says so and they',
  'do not. Both take nearest texels. zstrip has no reflections: three.js draws diffuse materials, with the lights that',
  '`zstrip render` has.',
];

const kCompared = [
  '- **read**: both draw the file, or neither does',
  '- **silhouette**: outlines and holes are at most one pixel apart',
  '- **colour**: without light; of what glows or is lit fully with it. Of all but 2 % of the pixels the colour is in',
  '  the other picture at most one pixel away, within a step of RGB565; means of 8x8 pixels within one and a half.',
  '  Two and three where something blends or colours are multiplied, which zstrip does as the screen shows them',
  '- **light**: brightness, of assimp\'s files with white materials: as colours, of all but 0.5 % of the pixels',
  '- **pose**: silhouettes at 1/4, 2/4 and 3/4 of the animation',
  '- **camera**: silhouettes through the file\'s own cameras',
];

const kWidth = 118;

/** An entry of a list in lines. */
function wrap(text) {
  const indent = '  ';
  const lines = [];
  let line = '';
  for (const word of text.split(' ')) {
    if (line.length + word.length >= kWidth) {
      lines.push(line.trimEnd());
      line = indent;
    }
    line += `${word} `;
  }
  return [...lines, line.trimEnd()];
}

/** The page docs/measured/viewer.md. */
export function tableOf(rows, expected) {
  const cell = (name, aspect) => {
    const row = rows.find((each) => each.case === name && each.aspect === aspect);
    if (!row) return '';
    if (differs(row)) return 'differs';
    if (aspect === 'read') return row.three ? 'neither' : 'both';
    return 'same';
  };
  const section = (title, source) => {
    const names = [...new Set(rows.filter((row) => row.source === source).map((row) => row.case))];
    return [
      `## ${title}`, `| File | ${kAspects.join(' | ')} |`, `|---|${kAspects.map(() => '---|').join('')}`,
      ...names.map((name) => `| \`${name}\` | ${kAspects.map((aspect) => cell(name, aspect)).join(' | ')} |`), ''
    ];
  };
  const reasons = new Map();
  for (const {case: name, aspect, reason} of expected) {
    reasons.set(reason, [...(reasons.get(reason) ?? []), `\`${name}\` (${aspect})`]);
  }
  return [
    '# glTF files in another viewer',
    '',
    ...kHead,
    '',
    ...kCompared,
    '',
    ...section('Files of assimp-testmodels', 'assimp-testmodels'),
    ...section('Files that Blender wrote', 'blender'),
    ...section('Files of one feature', 'generated'),
    '## What differs, and why',
    ...[...reasons].flatMap(([reason, names]) => wrap(`- ${reason}: ${names.join(', ')}`)),
    '',
  ].join('\n');
}
