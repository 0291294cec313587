/** What people can choose of a photograph. */

import { msg } from "@lit/localize";
import type { Size } from "#sculpture/film/darkroom";
import type { Wishes } from "../../photograph/orders";

type Finish = Pick<Wishes, "matte" | "colour" | "roughness">;

const metal = (roughness: number, ...colour: [number, number, number]): Finish => ({ matte: false, colour, roughness });
const paint = (...colour: [number, number, number]): Finish => ({ matte: true, colour, roughness: 0.5 });

/** Of what the wire is: colours linear, as light has them. */
export const FINISHES = {
  copper: { words: msg("Copper"), ...metal(0.42, 0.93, 0.52, 0.33) },
  brass: { words: msg("Brass"), ...metal(0.36, 0.88, 0.66, 0.28) },
  steel: { words: msg("Polished steel"), ...metal(0.3, 0.68, 0.68, 0.7) },
  black: { words: msg("Black steel"), ...metal(0.5, 0.1, 0.1, 0.11) },
  red: { words: msg("Red paint"), ...paint(0.55, 0.035, 0.025) },
  white: { words: msg("White paint"), ...paint(0.82, 0.81, 0.79) },
} as const;
export type FinishName = keyof typeof FINISHES;

/** How sharp shadows are: the lamps' size. */
export const SHADOWS = {
  sharp: { words: msg("Sharp"), lampRadius: 0.03, surround: 0.03 },
  soft: { words: msg("Soft"), lampRadius: 0.16, surround: 0.04 },
  softer: { words: msg("Very soft"), lampRadius: 0.7, surround: 0.08 },
} as const;
export type Shadows = keyof typeof SHADOWS;

/** Besides the lamps. */
export const SKIES = {
  room: { words: msg("Dim"), overcast: false, more: 1, exposure: 1 },
  grey: { words: msg("A grey sky"), overcast: true, more: 6, exposure: 0.4 },
} as const;
export type SkyName = keyof typeof SKIES;

export const PLACES = {
  room: { words: msg("A room's walls") },
  screens: { words: msg("Screens") },
  studio: { words: msg("A studio's floor") },
} as const;

export const FOCUS = {
  all: { words: msg("All of it"), aperture: 0 },
  wire: { words: msg("The wire alone"), aperture: 0.07 },
} as const;
export type Focus = keyof typeof FOCUS;

/** Samples of each pixel. */
export const PATIENCE = {
  quick: { words: msg("Quick"), passes: 8 },
  good: { words: msg("Good"), passes: 24 },
  best: { words: msg("Best"), passes: 64 },
} as const;
export type Patience = keyof typeof PATIENCE;

export const FORMATS = {
  wide: { words: msg("Wide"), size: { width: 1280, height: 720 } },
  full: { words: msg("Large"), size: { width: 1920, height: 1080 } },
  square: { words: msg("Square"), size: { width: 1080, height: 1080 } },
  tall: { words: msg("Tall"), size: { width: 810, height: 1440 } },
} as const satisfies Record<string, { readonly words: string; readonly size: Size }>;
export type Format = keyof typeof FORMATS;

export interface Choices {
  readonly finish: FinishName;
  readonly shadows: Shadows;
  readonly focus: Focus;
  readonly patience: Patience;
  readonly format: Format;
  /** Where shadows fall. */
  readonly place: keyof typeof PLACES;
  readonly sky: SkyName;
  /** From the corner that sees all shadows, or as the stage has it. */
  readonly from: "corner" | "stage";
}

/** From where all three walls are seen, degrees. */
const CORNER = { azimuth: 42, elevation: 28 } as const;

export function wishesFor({ finish, shadows, focus, format, place, sky, from }: Choices, stage: { readonly azimuth: number; readonly elevation: number } | null): Wishes {
  const { matte, colour, roughness } = FINISHES[finish];
  const { lampRadius, surround } = SHADOWS[shadows];
  const { overcast, more, exposure } = SKIES[sky];
  const { azimuth, elevation } = (from === "stage" && stage) || CORNER;
  return { size: FORMATS[format].size, seed: 0, place, matte, colour, roughness, lampRadius, surround: more * surround, overcast, azimuth, elevation, aperture: FOCUS[focus].aperture, exposure };
}
