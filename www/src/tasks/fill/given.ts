/** What a person gives: a mesh to be covered, and the style that the wire takes on. Immutable, without elements. */

import { msg } from "@lit/localize";
import type { Affects } from "../../engine/protocol";
import type { AddressForm } from "../../state/contract/task";
import { pixelsOf, type KeptPicture } from "../../state/picture/picture";
import { PATTERNS, SHAPES, type FillWork, type Mesh, type PatternName, type ShapeName } from "./protocol";

export interface Cover {
  readonly mesh: Mesh;
  /** By formula, or a person's own picture. */
  readonly style: PatternName | StylePicture | null;
}

/** The key tells it from its namesakes; what was kept before there were keys has none. */
export interface StylePicture extends KeptPicture {
  readonly key?: string;
}

const isShape = (word: string | undefined): word is ShapeName => SHAPES.some((shape) => shape === word);
const isPattern = (word: string | undefined): word is PatternName => PATTERNS.some((pattern) => pattern === word);

const SHAPE_WORDS: Readonly<Record<ShapeName, string>> = { creature: msg("Creature"), knot: msg("Knot"), vase: msg("Vase"), torus: msg("Torus"), sphere: msg("Sphere") };

/** "Creature", or what the file is called. */
export function meshName(mesh: Mesh): string {
  return "shape" in mesh ? SHAPE_WORDS[mesh.shape] : mesh.name;
}

/** Tells one shape from every other. */
export const meshKey = (mesh: Mesh): string => ("shape" in mesh ? mesh.shape : mesh.key);

/** Tells one style from every other. */
function styleKey(style: Cover["style"]): string {
  return style === null ? "" : typeof style === "string" ? style : (style.key ?? style.name);
}

/** What of a cover can travel in an address: a shape by formula, and on it a style by formula. */
export const address: AddressForm<Cover | null> = {
  keys: ["shape", "style"],
  write(cover) {
    if (!cover || !("shape" in cover.mesh)) return {};
    return { shape: cover.mesh.shape, ...(typeof cover.style === "string" && { style: cover.style }) };
  },
  read: ({ shape, style }) => (isShape(shape) ? { mesh: { shape }, style: isPattern(style) ? style : null } : null),
};

/** As the engine wants it. */
export async function workOf({ mesh, style }: Cover): Promise<FillWork> {
  return { mesh, style: style === null || typeof style === "string" ? style : await pixelsOf(style) };
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
export function curveKey({ mesh, style }: Cover, { value, affecting }: Settled): string {
  const styled = value("flow") === "style" ? [styleKey(style), ...affecting("styled-curve")] : [];
  return [meshKey(mesh), ...affecting("curve"), ...styled].join("|");
}
