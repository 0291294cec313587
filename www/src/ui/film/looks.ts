/** The looks as words, and as the colours that a picture has on light walls or dark ones. */

import { lookOf, type Look, type LookName } from "#sculpture/looks";
import { TINTS, type Tints } from "#sculpture/tints";

export const LOOK_WORDS: Readonly<Record<LookName, string>> = {
  copper: "Copper",
  steel: "Black steel",
  parameter: "Colours along the wire",
  width: "Colours by width",
};

/** Whatever the page's own colours are. */
export function lookFor(name: LookName, dark: boolean, room: boolean): Look {
  const tints = Object.fromEntries(Object.entries(TINTS).map(([tint, [light, dim]]) => [tint, dark ? dim : light])) as unknown as Tints;
  return lookOf(name, tints, room);
}
