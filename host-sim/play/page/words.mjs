// Messages of the command in the words of the page, which has settings where the command has options.
import {kSettings} from './settings.mjs';

const kOption = /(?<![\w-])--(no-)?([a-z][a-z-]*[a-z])/g;
const kHelp = /; see 'zstrip[^']*--help'/g;
const kShown = {option: '--show', label: 'Shown'};

const settingWith = (option) => [...kSettings, kShown].find((setting) => setting.option === option);

/** Options by the labels of their settings; those that the page does not have are the command's. */
export function inWordsOfPage(message) {
  return message.replace(kHelp, '').replace(kOption, (option, no, name) => {
    const label = settingWith(option)?.label ?? settingWith(`--${name}`)?.label;
    if (!label) return `the command's ${option}`;
    return option === `--no-${name}` ? `“${label}” off` : `“${label}”`;
  });
}

/** The name of the setting that a message of the command speaks of first; undefined if it speaks of none. */
export function settingOf(message) {
  for (const [, , name] of message.matchAll(kOption)) {
    const setting = settingWith(`--${name}`);
    if (setting?.name) return setting.name;
  }
}
