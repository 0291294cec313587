/** A shorter code for a wire that is too long for a link. */

import type { EngineClient } from "../../engine/client";

export interface Simplified {
  readonly code: string;
  /** How far its lines moved, pixels of a view of 512. */
  readonly meanPx: number;
  readonly maxPx: number;
}

/** What the engine answers; the call is the engine's newest, and an older one does not know it. */
interface Answer {
  readonly code: string;
  readonly moved_px: { readonly mean: number; readonly max: number };
}

type Asks = (call: "simplify", given: { readonly file: Uint8Array<ArrayBuffer>; readonly most: number }) => Promise<Answer | null>;

/** A code of at most so many characters; null where none is like the wire, or nobody makes one. */
export async function simplified(engine: EngineClient, file: Uint8Array<ArrayBuffer>, most: number): Promise<Simplified | null> {
  try {
    const answer = await (engine.call.bind(engine) as unknown as Asks)("simplify", { file, most });
    return answer && answer.code.length <= most ? { code: answer.code, meanPx: answer.moved_px.mean, maxPx: answer.moved_px.max } : null;
  } catch {
    return null;
  }
}
