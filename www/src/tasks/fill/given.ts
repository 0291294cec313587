/** What a person has covered: a shape, and the style that the wire takes on. Immutable, without elements. */

import { PATTERNS, SHAPES, type Affects, type Covered, type PatternName, type ShapeName, type Solid } from "../../engine/protocol";
import type { KeptPicture } from "../multiview/drawing/paper";
import { pixelsOf } from "../../state/picture/picture";

export { PATTERNS, SHAPES, type PatternName, type ShapeName, type Solid } from "../../engine/protocol";

export interface Cover {
  readonly solid: Solid;
  /** By formula, or a person's own picture. */
  readonly style: PatternName | StylePicture | null;
}

/** The key tells it from its namesakes; what was kept before there were keys has none. */
export interface StylePicture extends KeptPicture {
  readonly key?: string;
}

/** Of a link: what of a cover can travel. */
export interface CoverWords {
  readonly shape: ShapeName | null;
  readonly style: PatternName | null;
}

export const isShape = (word: string | null): word is ShapeName => SHAPES.some((shape) => shape === word);
export const isPattern = (word: string | null): word is PatternName => PATTERNS.some((pattern) => pattern === word);

/** "Creature", or what the file is called. */
export function solidName(solid: Solid): string {
  return "shape" in solid ? solid.shape.charAt(0).toUpperCase() + solid.shape.slice(1) : solid.name;
}

/** Tells one shape from every other. */
export const solidKey = (solid: Solid): string => ("shape" in solid ? solid.shape : solid.key);

/** Tells one style from every other. */
function styleKey(style: Cover["style"]): string {
  return style === null ? "" : typeof style === "string" ? style : (style.key ?? style.name);
}

export function wordsOf({ solid, style }: Cover): CoverWords {
  return { shape: "shape" in solid ? solid.shape : null, style: typeof style === "string" ? style : null };
}

/** As the engine wants it. */
export async function coveredOf({ solid, style }: Cover): Promise<Covered> {
  return { solid, style: style === null || typeof style === "string" ? style : await pixelsOf(style) };
}

/** What the settings are. */
export interface Settled {
  value(name: string): string;
  /** Values of the settings that change something. */
  affecting(what: Affects): readonly string[];
}

/** Tells apart wires on the same curve. */
export function lookKey({ style }: Cover, { affecting }: Settled): string {
  return [styleKey(style), ...affecting("look"), ...(style === null ? [] : affecting("styled-look"))].join("|");
}

/** Tells curves apart: two covers with the same one have the same curve. */
export function curveKey({ solid, style }: Cover, { value, affecting }: Settled): string {
  const styled = value("flow") === "style" ? [styleKey(style), ...affecting("styled-curve")] : [];
  return [solidKey(solid), ...affecting("curve"), ...styled].join("|");
}
