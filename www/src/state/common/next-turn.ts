/** Lets the browser do something else, such as answer a person, before what follows. */

const { port1, port2 } = new MessageChannel();
const waiting: (() => void)[] = [];
port1.onmessage = () => waiting.shift()!();

/** Resolves in a task of its own, in the order of asking. A timer would be slowed down where the page is not looked at. */
export function nextTurn(): Promise<void> {
  return new Promise((resolve) => {
    waiting.push(resolve);
    port2.postMessage(null);
  });
}
