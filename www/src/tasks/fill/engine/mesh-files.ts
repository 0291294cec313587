/** The wasm module that reads mesh files: fetched when somebody brings one. Only for the worker. */

import type { Up } from "../protocol";
import init, { MeshFile } from "../../../engine/wasm/wire4d_model";
import moduleUrl from "../../../engine/wasm/wire4d_model_bg.wasm?url";

/** What the main module takes. */
export interface ReadMesh {
  /** x, y, z for each corner, world units. */
  readonly positions: Float64Array;
  /** Three corners a triangle, counter-clockwise from outside. */
  readonly triangles: Uint32Array;
  /** What was mended, as a JSON list of sentences. */
  readonly notes: string;
  readonly up: Up;
}

let loading: Promise<unknown> | null = null;

/** A mesh from a file, read and mended; `up` is null for what is usual for its kind. */
export async function readMesh(name: string, file: Uint8Array, up: Up | null): Promise<ReadMesh> {
  try {
    await (loading ??= init({ module_or_path: moduleUrl }));
  } catch (error) {
    // The next file may find the way back.
    loading = null;
    console.error(error);
    throw new Error("The part of the engine that reads meshes could not be loaded. Check the connection and try again.");
  }
  const read = MeshFile.read(name, file, up);
  try {
    return { positions: read.positions(), triangles: read.triangles(), notes: read.notes(), up: read.up as Up };
  } finally {
    read.free();
  }
}
