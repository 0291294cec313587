/** What is asked of the camera, and what it answers. */

import type { Size } from "#sculpture/film/darkroom";

/** How the photograph is to be; angles in degrees, lengths in world units (the wire lies in a box of about 2). */
export interface Wishes {
  readonly size: Size;
  readonly seed: number;
  /** Where shadows fall; null: as suits the views that the wire was made for. */
  readonly place: "room" | "screens" | "studio" | null;
  readonly matte: boolean;
  /** Of the wire, linear, 0 to 1. */
  readonly colour: readonly [number, number, number];
  /** Of metal, 0 to 1. */
  readonly roughness: number;
  readonly lampRadius: number;
  /** Light from all round, as a share of a lamp's. */
  readonly surround: number;
  /** Whether that light comes as on a grey day. */
  readonly overcast: boolean;
  readonly azimuth: number;
  readonly elevation: number;
  readonly aperture: number;
  /** Stops. */
  readonly exposure: number;
}

export interface Order {
  readonly id: number;
  /** A wire.json. */
  readonly file: Uint8Array<ArrayBuffer>;
  readonly wishes: Wishes;
  /** Samples of each pixel; 0: a small picture alone. */
  readonly passes: number;
}

/** RGBA, rows from the top. */
export interface Pixels extends Size {
  readonly rgba: Uint8ClampedArray<ArrayBuffer>;
}

/** Nobody looks at the page: what is being taken waits. */
export interface Rest {
  readonly rests: boolean;
}

export type Told =
  | { readonly id: number; readonly pixels: Pixels; readonly passes: number }
  /** So many of all passes are done. */
  | { readonly id: number; readonly passes: number }
  | { readonly id: number; readonly done: Pixels }
  /** Why there is no photograph. */
  | { readonly id: number; readonly problem: string };
