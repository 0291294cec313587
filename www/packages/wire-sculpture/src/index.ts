/**
 * `<wire-sculpture>`: shows one continuous wire in a room, with a shadow on each wall. Run in a worker that the element
 * itself has started, the same module draws.
 */

import { WireSculpture } from "./element";
import { startOwnWorker, WORKER_NAME } from "./own-worker";
import { serve } from "./serving";

export { WireSculpture };
export type { SculptureState, ViewChange } from "./element";
export type { LookName } from "./looks";
export type { WireShape } from "./shape";
export type { View } from "./view";

if (typeof document === "undefined") {
  if ((globalThis as { name?: string }).name === WORKER_NAME) serve();
} else if (!customElements.get("wire-sculpture")) {
  WireSculpture.startWorker = () => startOwnWorker(WireSculpture.workerUrl);
  customElements.define("wire-sculpture", WireSculpture);
}
