/**
 * `<wire-sculpture>`: shows one continuous wire in a room, with a shadow on each wall. Run in a worker that the element
 * itself has started, the same module draws.
 */

import { WireSculpture } from "./element/element";
import { startOwnWorker, WORKER_NAME } from "./scene/own-worker";
import { serve } from "./scene/serving";

export { WireSculpture };
export type { SculptureState, ViewChange } from "./element/element";
export type { LookName } from "./scene/looks";
export type { WireShape } from "./scene/shape";
export type { View } from "./scene/view";

if (typeof document === "undefined") {
  if ((globalThis as { name?: string }).name === WORKER_NAME) serve();
} else if (!customElements.get("wire-sculpture")) {
  WireSculpture.startWorker = () => startOwnWorker(WireSculpture.workerUrl);
  customElements.define("wire-sculpture", WireSculpture);
}
