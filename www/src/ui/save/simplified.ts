/** A shorter code for a wire that is too long for a link. */

import type { EngineClient } from "../../engine/client";

/** A code that shows nearly the same wire, and how far its lines moved, in pixels of a view of 512 px. */
export interface Simplified {
  readonly code: string;
  readonly most_px: number;
  readonly mean_px: number;
}

/** The engine's newest call, which an older one does not know. */
type Asks = (call: "simplify", given: { readonly file: Uint8Array; readonly characters: number }) => Promise<Simplified | null>;

/** A code of at most so many characters; null where none shows anything like the wire, or nobody makes one. */
export async function simplified(engine: EngineClient, file: Uint8Array, characters: number): Promise<Simplified | null> {
  try {
    const simple = await (engine.call.bind(engine) as unknown as Asks)("simplify", { file, characters });
    return simple && simple.code.length <= characters ? simple : null;
  } catch {
    return null;
  }
}
