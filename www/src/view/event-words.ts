/** What happened in a run, for people. */

import type { RunEvent } from "../engine/protocol";

export function eventWords({ kind, count }: RunEvent): string {
  const points = count === 1 ? "1 point" : `${count} points`;
  switch (kind) {
    case "stage":
      return count > 1 ? `Part ${count} begins` : "The fit begins";
    case "restart":
      return "A fresh start at full stride";
    case "reinit":
      return `${points} that had vanished moved to where ink is lacking`;
    case "refine":
      return `${points} added where the pictures pull hardest`;
    case "respace":
      return `Laid anew at even steps: ${points}`;
    case "thin":
      return `${points} removed that the curve does not need`;
    case "undone":
      return "A step went wrong and was taken back; smaller steps from here";
    case "done":
      return "Done";
    case "unguided":
      return "What guided the wire failed; it goes on without";
  }
}
