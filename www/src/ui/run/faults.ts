/** Where a wire fails, in words. */

import { msg, str } from "@lit/localize";
import type { Faults } from "../../engine/protocol";
import { count, counted } from "../../words/numbers";

export const FAULTS = { tight: msg("Bends"), penetrating: msg("Strands") } as const satisfies Record<keyof Faults, string>;

export function faultWords(fault: keyof Faults, places: number): string {
  const where = counted(places, msg("in 1 place"), msg(str`in ${count(places)} places`));
  if (fault === "penetrating") return msg(str`passes through itself ${where}`);
  return places === 0 ? msg("nowhere tighter than a hand can bend") : msg(str`tighter than a hand can bend ${where}`);
}
