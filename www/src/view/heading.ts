/** Where one can look from, other than the views that a wire was made for. */

import { msg, str } from "@lit/localize";
import type { View } from "../engine/protocol";

/** Degrees: to the right of the front, and above it. */
export interface Heading {
  readonly azimuth: number;
  readonly elevation: number;
}

/** From where a view looks. */
export function headingOf({ eye, target }: Pick<View, "eye" | "target">): Heading {
  const [x, y, z] = [eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]];
  const degrees = 180 / Math.PI;
  return { azimuth: Math.atan2(x, z) * degrees, elevation: Math.atan2(y, Math.hypot(x, z)) * degrees };
}

/** World height of the picture: the unit ball, in which every wire hangs. */
const HEIGHT_WORLD = 2;
const SIZE_PX = 256;
/** From the middle; straight views do not mind. */
const AWAY = 3;

/** The straight view from a heading. */
export function viewFrom({ azimuth, elevation }: Heading, name: string): View {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  const [sinA, cosA, sinE, cosE] = [Math.sin(a), Math.cos(a), Math.sin(e), Math.cos(e)];
  return {
    name,
    projection: "orthographic",
    eye: [AWAY * sinA * cosE, AWAY * sinE, AWAY * cosA * cosE],
    target: [0, 0, 0],
    up: [-sinA * sinE, cosE, -cosA * sinE],
    height_world: HEIGHT_WORLD,
    width_px: SIZE_PX,
    height_px: SIZE_PX,
  };
}

const NAMES: Readonly<Record<string, string>> = { front: msg("front"), side: msg("side"), top: msg("top"), right: msg("right"), left: msg("left"), back: msg("back") };

/** "33,6", as the core calls a view that has no name, as "33° round, 6° up"; the core's names in the page's language, every other as it is. */
export function viewWords(name: string): string {
  if (Object.hasOwn(NAMES, name)) return NAMES[name]!;
  const found = /^(-?[\d.]+),(-?[\d.]+)$/.exec(name);
  if (!found) return name;
  const elevation = Number(found[2]);
  const round = found[1]!;
  if (!elevation) return msg(str`${round}° round`);
  const steep = Math.abs(elevation);
  return elevation > 0 ? msg(str`${round}° round, ${steep}° up`) : msg(str`${round}° round, ${steep}° down`);
}
