// Messages of the command, as the page says them: in the words that its settings have.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {kSettings} from '../../host-sim/play/page/settings.mjs';
import {inWordsOfPage, settingOf} from '../../host-sim/play/page/words.mjs';

test('no option of the command is named where the page has a setting', () => {
  for (const [message, words, setting] of [
    ["--size '240' must be WIDTHxHEIGHT", "“Size” '240' must be WIDTHxHEIGHT", 'size'],
    ['needs 9 bytes, and --ram allows 8; give --ram 9', 'needs 9 bytes, and “RAM at most” allows 8; give “RAM at most” 9', 'ram'],
    ['edges exclude samples; use --no-edges, or --samples 1', 'edges exclude samples; use “Smooth edges” off, or “Samples a pixel” 1', 'edges'],
    ['--show overdraw counts no --cull', "“Shown” overdraw counts no the command's --cull", undefined],
    ["use --strip-rows; see 'zstrip view --help'", 'use “Rows of a strip”', 'strip-rows'],
    ["'my--ram.obj' has -- no faces", "'my--ram.obj' has -- no faces", undefined],
  ]) {
    assert.equal(inWordsOfPage(message), words);
    assert.equal(settingOf(message), setting);
  }
});

test('each setting is found by its option', () => {
  for (const {name, label, option} of kSettings) {
    assert.equal(settingOf(`leave out ${option}.`), name);
    assert.equal(inWordsOfPage(`leave out ${option}.`), `leave out “${label}”.`);
  }
});
