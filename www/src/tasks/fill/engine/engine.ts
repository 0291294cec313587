/** A mesh that a wire covers, in the worker, which keeps the one that was last looked at. */

import { bytesOf, ink, loaded, pulled, shape } from "../../../engine/core";
import type { TaskEngine } from "../../../engine/task-engine";
import * as wasm from "../../../engine/wasm/wire4d";
import { readMesh } from "./mesh-files";
import type { FillWork, FoundSurface, Mesh, Up } from "../protocol";

/** What is told of a surface is kept beside it, since nobody may look at it while a run holds it. It keeps its last curve. */
interface Opened {
  readonly surface: wasm.Surface;
  readonly found: FoundSurface;
}

let last: { readonly key: string; readonly opened: Promise<Opened> } | null = null;

export const engine: TaskEngine<FillWork> = {
  task: "fill",
  handlers: {
    surface: async ({ mesh }) => (await surfaceOf(mesh)).found,
    curve: async ({ work, settings }, tell) => {
      const surface = await styled(work);
      return shape(surface.curve(JSON.stringify(settings), (share: number) => tell({ news: "share", share })));
    },
    pattern: async ({ pattern, sidePx }) => {
      await loaded();
      return ink(wasm.pattern(pattern, sidePx));
    },
    exportBefore: async ({ mesh, ...how }) => (await import("../../../engine/files")).exported(how, (await surfaceOf(mesh)).found),
  },
  async start(work, settings, from, { tell, note }) {
    const surface = await styled(work);
    const given = JSON.stringify(settings);
    return pulled(await (from ? wasm.Run.resume_fill(surface, given, from, tell, note) : wasm.Run.start_fill(surface, given, tell, note)));
  },
};

/** Read once, however often it is asked for. */
function surfaceOf(mesh: Mesh): Promise<Opened> {
  const key = "shape" in mesh ? mesh.shape : mesh.key;
  if (last?.key !== key) {
    // Whoever waits for it still has it first.
    void last?.opened.then(({ surface }) => setTimeout(() => surface.free()), () => undefined);
    const opened = open(mesh);
    last = { key, opened };
    opened.catch(() => {
      if (last?.opened === opened) last = null;
    });
  }
  return last.opened;
}

async function open(mesh: Mesh): Promise<Opened> {
  await loaded();
  if ("shape" in mesh) return read(wasm.Surface.built_in(mesh.shape), null);
  const { name, file, up } = mesh;
  const bytes = new Uint8Array(await file.arrayBuffer());
  const { positions, triangles, notes, up: taken } = await readMesh(name, bytes, up === undefined ? "y" : up);
  return read(wasm.Surface.mesh(name, positions, triangles, notes), taken);
}

function read(surface: wasm.Surface, up: Up | null): Opened {
  const found = {
    positions: surface.positions() as FoundSurface["positions"],
    indices: surface.indices() as FoundSurface["indices"],
    triangles: surface.triangle_count,
    notes: JSON.parse(surface.notes()) as string[],
    up,
  };
  return { surface, found };
}

/** The surface, and what the wire should look like from now on. */
async function styled({ mesh, style }: FillWork): Promise<wasm.Surface> {
  const { surface } = await surfaceOf(mesh);
  if (!style) surface.clear_style();
  else if (typeof style === "string") surface.set_pattern(style);
  else surface.set_style(style.name, style.width, style.height, bytesOf(style));
  return surface;
}
