/** Whether this browser can run the core at all. */

import { msg, str } from "@lit/localize";

/** A module of one function that makes a vector: valid only where SIMD is known. */
const SIMD = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]);

/** What is missing, in a sentence with what to do; empty where all is well. */
export function engineProblem(): string {
  const lacks = typeof Worker === "undefined" ? msg("background workers") : typeof WebAssembly === "undefined" || !WebAssembly.validate(SIMD) ? msg("fast WebAssembly") : "";
  return lacks && msg(str`This browser has no ${lacks}, so it cannot find new wires. Looking at wires from links works; to make one, use a newer browser.`);
}
