/** Frames of the page for those who paint large pictures: what the browser does with each comes with the frame. */

let last: Promise<unknown> = Promise.resolve();

/** Resolves in a frame of its own, in the order of asking; in a hidden tab there is none until somebody looks. */
export function frameTurn(): Promise<unknown> {
  return (last = last.then(() => new Promise(requestAnimationFrame)));
}
