// Headless Chromium by its debugging protocol over two pipes: what a user does with mouse, keys and files.
import {spawn} from 'node:child_process';

const kOptions = [
  '--headless=new', '--no-sandbox',  // it runs as root in containers, and shows no page but ours
  '--remote-debugging-pipe', '--disable-gpu', '--disable-background-networking', '--disable-component-update',
  '--disable-extensions', '--disable-sync', '--force-color-profile=srgb', '--force-device-scale-factor=1',
  '--no-default-browser-check', '--no-first-run', '--hide-scrollbars'
];

export class Chromium {
  #process;
  #calls = 0;
  #waiting = new Map();
  #session;

  /** `profile`: a folder of its own. */
  constructor(chromium, profile) {
    this.#process = spawn(chromium, [...kOptions, `--user-data-dir=${profile}`, 'about:blank'],
      {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    let text = '';
    this.#process.stdio[4].on('data', (data) => {
      text += data;
      const messages = text.split('\0');
      text = messages.pop();
      for (const message of messages) this.#take(JSON.parse(message));
    });
    this.#process.on('exit', () => {
      for (const {reject} of this.#waiting.values()) reject(new Error('chromium has ended'));
    });
    /** What the page has logged as an error or thrown. */
    this.errors = [];
  }

  #take({id, result, error, method, params}) {
    if (method === 'Runtime.exceptionThrown') this.errors.push(params.exceptionDetails.exception?.description);
    if (method === 'Log.entryAdded' && params.entry.level === 'error') this.errors.push(`${params.entry.text} ${params.entry.url}`);
    const waiting = this.#waiting.get(id);
    if (!waiting) return;
    this.#waiting.delete(id);
    if (error) {
      waiting.reject(new Error(error.message));
    } else {
      waiting.resolve(result);
    }
  }

  call(method, params = {}) {
    return new Promise((resolve, reject) => {
      const id = ++this.#calls;
      this.#waiting.set(id, {resolve, reject});
      this.#process.stdio[3].write(JSON.stringify({id, method, params, sessionId: this.#session}) + '\0');
    });
  }

  async open(url) {
    const {targetInfos} = await this.call('Target.getTargets');
    const {targetId} = targetInfos.find(({type}) => type === 'page');
    ({sessionId: this.#session} = await this.call('Target.attachToTarget', {targetId, flatten: true}));
    for (const part of ['Page', 'Runtime', 'Log']) await this.call(`${part}.enable`);
    await this.call('Page.navigate', {url});
  }

  /** The value of an expression in the page, awaited. */
  async evaluate(expression) {
    const {result, exceptionDetails} = await this.call('Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async until(expression, seconds, what) {
    const end = Date.now() + 1000 * seconds;
    while (Date.now() < end) {
      if (await this.evaluate(expression)) return;
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
    throw new Error(`after ${seconds} s: ${what}`);
  }

  /** The middle of an element, in the window. */
  async middle(selector) {
    return this.evaluate(`(() => {
      const element = document.querySelector(${JSON.stringify(selector)});
      element.scrollIntoView({block: 'center'});
      const {x, y, width, height} = element.getBoundingClientRect();
      return {x: x + width / 2, y: y + height / 2};
    })()`);
  }

  /** Clicks so many pixels beside the middle of an element. */
  async click(selector, x = 0, y = 0) {
    const middle = await this.middle(selector);
    const at = {x: middle.x + x, y: middle.y + y};
    for (const type of ['mousePressed', 'mouseReleased']) {
      await this.call('Input.dispatchMouseEvent', {type, ...at, button: 'left', buttons: 1, clickCount: 1});
    }
  }

  async drag(selector, x, y) {
    const at = await this.middle(selector);
    const to = {x: at.x + x, y: at.y + y};
    await this.call('Input.dispatchMouseEvent', {type: 'mousePressed', ...at, button: 'left', buttons: 1, clickCount: 1});
    await this.call('Input.dispatchMouseEvent', {type: 'mouseMoved', ...to, button: 'left', buttons: 1});
    await this.call('Input.dispatchMouseEvent', {type: 'mouseReleased', ...to, button: 'left', clickCount: 1});
  }

  async press(key, windowsVirtualKeyCode, text = undefined) {
    for (const type of ['keyDown', 'keyUp']) {
      await this.call('Input.dispatchKeyEvent', {type, key, code: key, windowsVirtualKeyCode, text: type === 'keyDown' ? text : undefined});
    }
  }

  async type(text) {
    await this.call('Input.insertText', {text});
  }

  /** Files of this machine, let go over an element. */
  async drop(selector, files) {
    const at = await this.middle(selector);
    const data = {items: [], files, dragOperationsMask: 1};
    for (const type of ['dragEnter', 'dragOver', 'drop']) await this.call('Input.dispatchDragEvent', {type, ...at, data});
  }

  async close() {
    const ended = new Promise((resolve) => this.#process.on('exit', resolve));
    this.call('Browser.close').catch(() => {});
    await ended;
  }
}
