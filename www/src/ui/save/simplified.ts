/** A shorter code for a wire that is too long for a link. */

import type { EngineClient } from "../../engine/client";
import type { Simplified } from "../../engine/protocol";

/** A code of at most so many characters, and how far its lines moved; null where none shows anything like the wire. */
export async function simplified(engine: EngineClient, file: Uint8Array<ArrayBuffer>, characters: number): Promise<Simplified | null> {
  try {
    return await engine.call("simplify", { file, characters });
  } catch (error) {
    // An offer less: the wire itself is there all the same.
    console.error(error);
    return null;
  }
}
