// Background and light of a scene file's text are changed where they stand, and a link brings files back.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {kMaxPacked, pack, unpack} from '../../host-sim/play/page/packed_files.mjs';
import {backgroundOf, lineOfError, withBackground, withLight} from '../../host-sim/play/page/scene_text.mjs';
import {linkOf, settingsOf} from '../../host-sim/play/page/settings.mjs';

test('the background of a text is read and replaced, of labels and tables never', () => {
  for (const [text, colour, changed] of [
    ['background = "#e09a86"\nambient = 3\n', '#e09a86', 'background = "#010203"\nambient = 3\n'],
    ['background = [1, 20, 255] # night\n', '#0114ff', 'background = "#010203" # night\n'],
    ["a = 1\n background='#ABCDEF'", '#abcdef', 'a = 1\n background="#010203"'],
    ['# A scene.\n[overlay]\nbackground = "#ffffff"\n', undefined,
      '# A scene.\nbackground = "#010203"\n[overlay]\nbackground = "#ffffff"\n'],
    ['background = [300, 0, 0]\n', undefined, 'background = "#010203"\n'],
    ['', undefined, 'background = "#010203"\n'],
  ]) {
    assert.equal(backgroundOf(text), colour, text);
    assert.equal(withBackground(text, '#010203'), changed);
    assert.equal(backgroundOf(changed), '#010203');
  }
});

test('the first light that has a direction is turned, or one is added', () => {
  const point = '[[light]]\ntype = "point"\nposition = [0, 1, 0]\n';
  for (const [text, changed] of [
    [`${point}[[light]]\n  direction = [1, 2,\n 3] # sun\n[camera]\n`, `${point}[[light]]\n  direction = [1, -0.5, 0] # sun\n[camera]\n`],
    ['[camera]\ndirection = [1, 2, 3]', '[camera]\ndirection = [1, 2, 3]\n\n[[light]]\ndirection = [1, -0.5, 0]\n'],
  ]) assert.equal(withLight(text, '-1,0.5,0'), changed);
});

test('the line of an error is that of the edited file alone', () => {
  assert.deepEqual(lineOfError("'a b.toml' line 12: a scene: no 'x'", 'a b.toml'), {line: 12, words: "a scene: no 'x'"});
  assert.equal(lineOfError("'other.toml' line 12: no", 'a.toml'), undefined);
  assert.equal(lineOfError('too little memory', 'a.toml'), undefined);
});

test('files in a link come back, and a damaged link is said', async () => {
  const files = [
    {path: 'ä/b.toml', bytes: new TextEncoder().encode('background = "#102030"\n'.repeat(40))},
    {path: 'model.stl', bytes: Uint8Array.from({length: 500}, (_, i) => (i * i) % 251)},
    {path: 'empty', bytes: new Uint8Array()},
  ];
  const packed = await pack(files);
  assert.ok(packed.length < kMaxPacked);
  const link = linkOf({scene: 'ä/b.toml', ram: '22K'}, {look: 0, frame: 7, yaw: 0, pitch: 0, zoom: 0}, packed);
  const taken = settingsOf(link);
  assert.deepEqual([taken.settings, taken.view.frame, taken.plays], [{scene: 'ä/b.toml', ram: '22K'}, 7, false]);
  assert.deepEqual((await unpack(taken.files)).map(({path, bytes}) => [path, [...bytes]]), files.map(({path, bytes}) => [path, [...bytes]]));
  for (const damaged of [packed.slice(0, -20), '!', '']) await assert.rejects(unpack(damaged), /files in the link cannot be read/);
});

test('a link without a scene opens the lighthouse in 22 KB of a Pico, and it plays', () => {
  const {settings, plays} = settingsOf('');
  assert.deepEqual([settings, plays], [{scene: 'gallery/lighthouse.toml', ram: '22K', board: 'pico'}, true]);
  assert.deepEqual(settingsOf(linkOf(settings, {frame: undefined}, undefined)).settings, settings);
  assert.deepEqual(settingsOf('#scene=teapot').settings, {scene: 'teapot'});
});
