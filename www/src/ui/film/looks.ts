/** The looks as words, and as the colours that a picture has on light walls or dark ones. */

import { msg } from "@lit/localize";
import { lookOf, type Look, type LookName } from "#sculpture/scene/looks";
import { usualTints } from "#sculpture/scene/tints";

export const LOOK_WORDS: Readonly<Record<LookName, string>> = {
  copper: msg("Copper"),
  steel: msg("Black steel"),
  parameter: msg("Colours along the wire"),
  width: msg("Colours by width"),
};

export const lookFor = (name: LookName, dark: boolean, room: boolean): Look => lookOf(name, usualTints(dark), room);
