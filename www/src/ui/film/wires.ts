/** The wires of a run for a film of it. */

import type { WireShape } from "#sculpture/shape";

/** As many as a film has moments of change; the way between them is drawn evenly. */
const MOST_WIRES = 60;

/** Evenly chosen of those on the way, and the finished one at the end. */
export function wiresFor(way: readonly WireShape[], finished: WireShape): WireShape[] {
  const most = MOST_WIRES - 1;
  const chosen = way.length <= most ? way : Array.from({ length: most }, (_, i) => way[Math.floor((i * way.length) / most)]!);
  return [...chosen, finished].map(light);
}

/** In arrays that a worker is handed quickly. */
function light({ closed, knots, controlPoints }: WireShape): WireShape {
  return { closed, knots: Float32Array.from(knots), controlPoints: Float32Array.from(controlPoints) };
}
