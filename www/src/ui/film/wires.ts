/** The wires of a run for a film of it. */

import { fromBase64 } from "#sculpture/share/base64";
import { openReplay } from "#sculpture/share/replay";
import type { WireShape } from "#sculpture/scene/shape";
import type { Made } from "../../state/keeping/document";

/** As many as a film has moments of change; the way between them is drawn evenly. */
const MOST_WIRES = 60;

/** Those that a wire went through: of its run on this page, or what its file says of one. None where nobody kept them. */
export function wayOf({ track, finished }: Pick<Made, "track" | "finished">): readonly WireShape[] {
  // What loose strokes went through is another wire's way.
  if (track) return track.loose ? [] : track.snapshots.map(({ wire }) => wire);
  try {
    const { replay } = JSON.parse(new TextDecoder().decode(finished.file)) as { replay?: unknown };
    const bytes = typeof replay === "string" ? fromBase64(replay) : null;
    // The last one is the wire itself.
    return bytes ? openReplay(bytes).slice(0, -1).map(({ wire }) => wire) : [];
  } catch (error) {
    // A wire without its past is one all the same.
    console.warn(error);
    return [];
  }
}

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
