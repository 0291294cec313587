/** What is asked of the workshop, and what it answers. Lengths in millimetres. */

export const METALS = ["copper", "aluminium", "steel"] as const;
export type MetalName = (typeof METALS)[number];
export type PaperName = "a4" | "letter";

export interface Wishes {
  /** What it is called on paper and on a plate. */
  readonly name: string;
  /** The longest side. */
  readonly sizeMm: number;
  readonly wireMm: number;
  readonly metal: MetalName;
  /** How long a piece of wire is, as one buys it. */
  readonly stockMm: number;
  readonly paper: PaperName;
  /** Whether a print stands on a plate with its name. */
  readonly plate: boolean;
}

/** A step of bending: the points from `from` to `to` are new. */
export interface Step {
  readonly from: number;
  readonly to: number;
  /** From where it is best seen. */
  readonly azimuth_deg: number;
  readonly elevation_deg: number;
  readonly sentence: string;
}

/** Whether and how it can be built. */
export interface Plan {
  readonly passes: boolean;
  readonly sentences: readonly string[];
  readonly length_mm: number;
  readonly mass_g: number;
  readonly bends: number;
  /** The middle of the wire. */
  readonly points: readonly (readonly [number, number, number])[];
  readonly closed: boolean;
  readonly steps: readonly Step[];
}

export const KINDS = ["pdf", "md", "csv", "3mf", "stl", "jig"] as const;
export type Kind = (typeof KINDS)[number];

export interface Order {
  readonly id: number;
  /** A wire.json. */
  readonly file: Uint8Array<ArrayBuffer>;
  readonly wishes: Wishes;
  /** A file, or else the plan. */
  readonly kind: Kind | null;
}

export type Told = { readonly id: number } & ({ readonly plan: Plan } | { readonly made: Uint8Array<ArrayBuffer> } | { readonly problem: string });
