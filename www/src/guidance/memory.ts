/** What a network will take of a device's memory, told before it is loaded. */

import { GuidanceError, size } from "./fault";
import type { Sidecar, Weights } from "./sidecar";

type Load = Pick<Sidecar, "bytes" | "weights">;

/** How much larger weights are when they are opened: arithmetic is fp32. */
const UNPACKED: Readonly<Record<Weights, number>> = { fp32: 1, fp16: 2, int8: 4 };
/** What a 32-bit wasm memory can hold. */
const WASM_BYTES = 2 ** 32;
/** Of a device's memory; the rest is the system's, the browser's, and other tabs'. */
const SHARE = 0.5;
/** Where a browser does not say: a phone's, and another device's. */
const [PHONE_GIB, OTHER_GIB] = [3, 8];

/** Bytes at the worst moment: the file, the runtime's copy of it, and the weights unpacked. */
export const memoryOf = ({ bytes, weights }: Load): number => bytes * (2 + UNPACKED[weights]);

/** Throws a GuidanceError for a network that is too large for a device of so much memory. */
export function refuseTooLarge(file: string, load: Load, deviceGib = deviceMemory()): void {
  const fail = (what: string): never => {
    throw new GuidanceError(file, `“${file}” needs about ${size(needed)} of memory to be opened, and ${what}`);
  };
  const needed = memoryOf(load);
  const spare = SHARE * deviceGib * 2 ** 30;
  // The file itself lies outside.
  if (needed - load.bytes > WASM_BYTES) fail("that is more than a browser can give. Take a smaller model.");
  if (needed > spare) fail(`this device can spare about ${size(spare)}. Take a smaller model, or a device with more memory.`);
}

/** GiB, as far as the browser tells: it rounds, and says no more than 8. */
function deviceMemory(): number {
  const { deviceMemory, userAgent } = navigator as Navigator & { readonly deviceMemory?: number };
  return deviceMemory ?? (/Mobi|Android|iPhone|iPad/.test(userAgent) ? PHONE_GIB : OTHER_GIB);
}
