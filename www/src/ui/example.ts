/**
 * What a first visit shows: three drawings, and the wire made of them with the usual settings, as a share code
 * (`wire4d multiview`, then `wire4d share`).
 */

import front from "../../../tests/drawings/t01-animals/front.png?url";
import side from "../../../tests/drawings/t01-animals/side.png?url";
import top from "../../../tests/drawings/t01-animals/top.png?url";
import code from "./example.code?url";
import type { Slot } from "../state/studio";

export const EXAMPLE: Readonly<Record<Slot, string>> = { front, side, top };
export const EXAMPLE_CODE = code;
