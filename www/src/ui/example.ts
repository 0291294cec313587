/**
 * What a first visit shows: three drawings, and the wire that `wire4d multiview` made of them with its usual settings.
 */

import front from "../../../tests/drawings/t01-animals/front.png?url";
import side from "../../../tests/drawings/t01-animals/side.png?url";
import top from "../../../tests/drawings/t01-animals/top.png?url";
import wire from "./example.wire.json?url";
import type { Slot } from "../state/studio";

export const EXAMPLE: Readonly<Record<Slot, string>> = { front, side, top };
export const EXAMPLE_WIRE = wire;
