/** What the page's end of this task and its engine tell each other. */

import type { WireShape } from "#sculpture/scene/shape";
import type { Picture } from "../../engine/protocol";

/** Shapes and styles by formula, by the core's words, in the order people are shown. */
export const SHAPES = ["sphere", "torus", "knot", "vase", "creature"] as const;
export type ShapeName = (typeof SHAPES)[number];
export const PATTERNS = ["petals", "waves", "calligraphy", "scales", "leaves"] as const;
export type PatternName = (typeof PATTERNS)[number];

/** The axis of a file that points up. */
export type Up = "y" | "z";

/** The mesh that is to be covered: of a shape by formula, or from a file. */
export type Mesh = { readonly shape: ShapeName } | MeshFile;

export interface MeshFile {
  /** Tells it from every other, also from its namesakes and from itself turned another way. */
  readonly key: string;
  readonly name: string;
  readonly file: Blob;
  /** Null for what is usual for its kind. What was kept before there was a choice has none, and y is up in it. */
  readonly up?: Up | null;
}

/** What goes into a run: what it covers, and the picture whose look the wire takes on. */
export interface FillWork {
  readonly mesh: Mesh;
  readonly style: PatternName | Picture | null;
}

/** Triangles of a surface. */
export interface Body {
  /** x, y, z for each corner, world units; the whole fits the unit ball. */
  readonly positions: Float32Array<ArrayBuffer>;
  /** Three corners a triangle, counter-clockwise from outside. */
  readonly indices: Uint32Array<ArrayBuffer>;
}

export interface FoundSurface extends Body {
  readonly triangles: number;
  /** What was mended about it, in sentences. */
  readonly notes: readonly string[];
  /** The axis that was up in its file; null for a shape by formula. */
  readonly up: Up | null;
}

declare module "../../engine/protocol" {
  interface Calls {
    /** A mesh's triangles, and what was mended about it. */
    surface: { arguments: { mesh: Mesh }; answer: FoundSurface };
    /** How the wire would run over it, before anything is fitted: `share` tells how far that is. */
    curve: { arguments: { work: FillWork; settings: SettingValues }; answer: WireShape };
    /** The picture of a style by formula. */
    pattern: { arguments: { pattern: PatternName; sidePx: number }; answer: Ink };
    /** As `export`, without what is behind the mesh. */
    exportBefore: { arguments: ExportArguments & { mesh: Mesh }; answer: Uint8Array<ArrayBuffer> };
  }
}
