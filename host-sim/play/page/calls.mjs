// Calls of the worker: an answer for each, in their order.
const worker = new Worker('worker.mjs', {type: 'module'});
const waiting = new Map();
let calls = 0;

worker.onmessage = ({data: {id, result, error}}) => {
  const {resolve, reject} = waiting.get(id);
  waiting.delete(id);
  if (error) {
    reject(Object.assign(new Error(error.message), error));
  } else {
    resolve(result);
  }
};
worker.onerror = (event) => {
  for (const {reject} of waiting.values()) reject(new Error(event.message ?? 'the worker cannot be loaded'));
  waiting.clear();
};

// Calls a function of worker.mjs. A failure has a `message`, the `status` of the command, and the other printed
// `messages`.
export const call = (name, values) => new Promise((resolve, reject) => {
  waiting.set(++calls, {resolve, reject});
  worker.postMessage({id: calls, name, values});
});
