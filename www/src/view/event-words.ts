/** What happened in a run, for people. */

import { msg, str } from "@lit/localize";
import type { RunEvent } from "../engine/protocol";
import { counted } from "../words/numbers";

export function eventWords({ kind, count }: RunEvent): string {
  const points = counted(count, msg("1 point"), msg(str`${count} points`));
  switch (kind) {
    case "stage":
      return count > 1 ? msg(str`Part ${count} begins`) : msg("The fit begins");
    case "restart":
      return msg("A fresh start at full stride");
    case "reinit":
      return msg(str`${points} that had vanished moved to where ink is lacking`);
    case "refine":
      return msg(str`${points} added where the pictures pull hardest`);
    case "respace":
      return msg(str`Laid anew at even steps: ${points}`);
    case "thin":
      return msg(str`${points} removed that the curve does not need`);
    case "undone":
      return msg("A step went wrong and was taken back; smaller steps from here");
    case "done":
      return msg("Done");
    case "unguided":
      return msg("What guided the wire failed; it goes on without");
  }
}
