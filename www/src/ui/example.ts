/** What the pads hold on a first visit. */

import front from "../../../tests/drawings/t01-animals/front.png?url";
import side from "../../../tests/drawings/t01-animals/side.png?url";
import top from "../../../tests/drawings/t01-animals/top.png?url";
import type { Slot } from "../state/studio";

export const EXAMPLE: Readonly<Record<Slot, string>> = { front, side, top };
