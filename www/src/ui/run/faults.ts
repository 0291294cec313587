/** Where a wire fails, in words. */

import type { Faults } from "../../engine/protocol";
import { count } from "../../state/common/count";

export const FAULTS = { tight: "Bends", penetrating: "Strands" } as const satisfies Record<keyof Faults, string>;

export function faultWords(fault: keyof Faults, places: number): string {
  const where = `in ${count(places)} place${places === 1 ? "" : "s"}`;
  if (fault === "penetrating") return `passes through itself ${where}`;
  return places === 0 ? "nowhere tighter than a hand can bend" : `tighter than a hand can bend ${where}`;
}
