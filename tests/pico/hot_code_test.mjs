// The check of the list of hot code finds what would go wrong.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {complaintsOf, entriesOf} from './hot_code.mjs';

const kScript = `
    /* Triangles */
    *(.text.draw_*)
    *(.text._ZN4setup*C*) /* Thumb-1 */
    *(.text.scan) /* Thumb-2 */
    . = ALIGN(8);
`;
const ram = {begin: 0x20001000}, flash = {begin: 0x10001000};
const functions = {draw_small: ram, _ZN4setupIiEC1Ev: ram, main: flash, draw_small_veneer: flash};
function complaints(changes, {script = kScript, thumb = 'Thumb-1', inlines = false} = {}) {
  const places = Object.entries({...functions, ...changes}).filter(([, place]) => place);
  return complaintsOf(script, new Map(places), thumb, inlines);
}

test('all entries and their marks are read', () => {
  assert.deepEqual(entriesOf(kScript).map(({pattern, mark}) => [pattern, mark]),
      [['draw_*', undefined], ['_ZN4setup*C*', 'Thumb-1'], ['scan', 'Thumb-2']]);
  assert.deepEqual(complaints({}, {script: `${kScript}*(.text.one .text.two)\n`}),
      ['the script has 4 entries, of which 3 can be read']);
});

test('a program that is as the list says', () => assert.deepEqual(complaints({}), []));

test('a function that has another name, or was inlined', () => {
  assert.deepEqual(complaints({draw_small: undefined, paint_small: flash}), ['no function of draw_*']);
  assert.deepEqual(complaints({_ZN4setupIiEC1Ev: undefined}), ['no function of _ZN4setup*C*']);
});

test('a mark that is wrong', () => {
  assert.deepEqual(complaints({scan: ram}), ['scan is marked Thumb-2, and has functions on Thumb-1']);
  assert.deepEqual(complaints({}, {thumb: 'Thumb-2'}),
      ['_ZN4setup*C* is marked Thumb-1, and has functions on Thumb-2', 'no function of scan']);
  assert.deepEqual(complaints({}, {script: kScript.replace('Thumb-2', 'Thumb-3')}), ['unknown mark Thumb-3']);
});

test('a function at the wrong place', () => {
  assert.deepEqual(complaints({draw_small: flash}), ['draw_small is at 10001000']);
  assert.deepEqual(complaints({main: ram}), ['main is at 20001000']);
});

test('another compiler may inline some, not most', () => {
  const more = ['a', 'b', 'c'].map((name) => `*(.text.draw_${name})\n`).join('');
  const gone = {_ZN4setupIiEC1Ev: undefined}, places = {draw_a: ram, draw_b: ram, draw_c: ram};
  assert.deepEqual(complaints({...gone, ...places}, {script: kScript + more, inlines: true}), []);
  assert.equal(complaints({...gone, draw_a: ram}, {script: kScript + more, inlines: true}).length, 3);
});
