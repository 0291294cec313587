/** The wasm module that writes files and simpler links: fetched when somebody saves or shares a wire. Only for the worker. */

import { own, type Bytes } from "./core";
import type { ExportArguments, Simplified, SimplifyArguments } from "./protocol";
import init, * as wasm from "./wasm/wire4d_files";
import moduleUrl from "./wasm/wire4d_files_bg.wasm?url";

/** What hides lines of a drawing: x, y, z of each corner, world units, and three corners a triangle. */
export interface Solid {
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
}

let loading: Promise<unknown> | null = null;

async function loaded(): Promise<typeof wasm> {
  try {
    await (loading ??= init({ module_or_path: moduleUrl }));
  } catch (error) {
    // The next file may find the way back.
    loading = null;
    console.error(error);
    throw new Error("The part of the engine that writes files could not be loaded. Check the connection and try again.");
  }
  return wasm;
}

export async function exported({ file, format, view }: ExportArguments, solid?: Solid): Promise<Bytes> {
  return own((await loaded()).export_file(file, format, view, solid?.positions ?? new Float32Array(), solid?.indices ?? new Uint32Array()));
}

export async function withWire(picture: Bytes, file: Bytes): Promise<Bytes> {
  return own((await loaded()).picture_with_wire(picture, file));
}

export async function simplified({ file, characters }: SimplifyArguments): Promise<Simplified | null> {
  return JSON.parse((await loaded()).simplify(file, characters) ?? "null") as Simplified | null;
}
