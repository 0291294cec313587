/** Where a run is computed, in words. */

import { msg, str } from "@lit/localize";
import type { Place } from "../../engine/protocol";
import { count, decimal } from "../../words/numbers";
import { WORDS } from "./setting-words";

/** "Graphics card · Apple M2"; a processor has no name that says more. */
export function deviceOf({ backend, device }: Place): string {
  const kind = WORDS["backend"]!.choices![backend]!;
  return device && device.toLowerCase() !== kind.toLowerCase() ? `${kind} · ${device}` : kind;
}

/** "The processor does the work, as the settings ask. It uses 2 of its cores." */
export function reasonOf({ why, workers = 1 }: Place): string {
  return workers > 1 ? msg(str`${why} It uses ${workers} of its cores.`) : why;
}

/** "840 steps a second". */
export function paceOf(iterationsPerSecond: number): string {
  const rounded = iterationsPerSecond < 10 ? decimal(iterationsPerSecond, 1) : count(Math.round(iterationsPerSecond));
  return msg(str`${rounded} steps a second`);
}
