/** The main wasm module in the page's own words. Imported by the worker and by nothing else. */

import type { WireShape } from "../embed/shape";
import type {
  Backend,
  Covered,
  Drawing,
  ExportFormat,
  Faults,
  Finished,
  FoundInk,
  FoundObject,
  FoundSurface,
  Frame,
  Ink,
  Job,
  Measures,
  PatternName,
  Picture,
  Place,
  Placed,
  Preview,
  Reading,
  RunEvent,
  SettingsTable,
  SettingsTables,
  SettingValues,
  ShapeName,
  Sitter,
  Snapshot,
  SolidFile,
  Target,
  Up,
  View,
  Work,
} from "./protocol";
import { readMesh } from "./model";
import init, * as wasm from "./wasm/wire4d";
import moduleUrl from "./wasm/wire4d_bg.wasm?url";

type Bytes = Uint8Array<ArrayBuffer>;

/** A wire's numbers in buffers of their own, which can be given away. */
export interface OwnShape extends WireShape {
  readonly knots: Float64Array<ArrayBuffer>;
  readonly controlPoints: Float32Array<ArrayBuffer>;
}

export interface CoreRun {
  readonly iteration: number;
  readonly iterations: number;
  /** Up to `count` iterations; what happened. */
  step(count: number): Promise<readonly RunEvent[]>;
  /** Where it is computed now: a device may be lost on the way. */
  place(): Place;
  frame(): Omit<Frame, "iterationsPerSecond"> & { readonly wire: OwnShape };
  snapshot(): Snapshot & { readonly wire: OwnShape };
  targets(): Target[];
  /** The best wire so far, measured. */
  finish(): Finished;
  free(): void;
}

/** A shape to be covered. It keeps its last curve. */
export interface CoreSurface {
  found(): FoundSurface;
  /** What the wire should look like from now on. */
  dress(style: Covered["style"]): void;
  curve(settings: SettingValues, tell: (share: number) => void): OwnShape;
  start(settings: SettingValues, from: Bytes | null, ears: Ears): Promise<CoreRun>;
  export(file: Bytes, format: ExportFormat, view: string): Bytes;
  free(): void;
}

/** What the core says while it starts: how far it is, and what a person should know about the drawings. */
export interface Ears {
  tell(words: string, share: number): void;
  note(words: string): void;
}

/** The smallest module that uses SIMD: a function that makes a vector and drops it. */
const SIMD = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 9, 1, 7, 0, 65, 0, 253, 15, 26, 11,
]);

/** Loads the module; why that does not work is said in a sentence for people. */
async function load(): Promise<typeof core> {
  if (typeof WebAssembly === "undefined" || !WebAssembly.validate(SIMD)) {
    throw new Error(
      "This browser lacks WebAssembly SIMD, which the engine needs; wires from links can still be looked at. " +
        "Update the browser, or use a current Firefox, Chrome, Edge or Safari.",
    );
  }
  try {
    await init({ module_or_path: moduleUrl });
    return core;
  } catch (error) {
    console.error(error);
    throw new Error("The engine could not be loaded. Check the connection and reload the page.");
  }
}

const core = {
  settings(): SettingsTables {
    const table = (job: Job): SettingsTable => JSON.parse(wasm.settings_table(job)) as SettingsTable;
    return { multiview: table("multiview"), stroke: table("stroke"), fill: table("fill") };
  },

  place: async (backend: Backend): Promise<Place> => JSON.parse(await wasm.place(backend)) as Place,

  read(picture: Picture, reading: Reading): FoundInk {
    const found = wasm.read_ink(picture.name, picture.width, picture.height, bytesOf(picture), reading.ink, reading.threshold);
    return taken(found, () => ({ ...ink(found.ink()), polarity: found.is_light ? "light" : "dark", note: found.note() }));
  },

  preview(drawings: readonly Drawing[], settings: SettingValues): Preview {
    const found = taken(set(drawings), (drawings) => wasm.Preview.of(drawings, JSON.stringify(settings)));
    return taken(found, () => {
      type Words = Omit<Preview, "drawings"> & { readonly drawings: readonly Placed[] };
      const words = JSON.parse(found.words()) as Words;
      const pictures = (index: number) => ({ seen: ink(found.seen(index)), missing: ink(found.missing(index)) });
      return { ...words, drawings: words.drawings.map((placed, index) => ({ ...placed, ...pictures(index) })) };
    });
  },

  find(picture: Picture, object: number): FoundObject {
    const found = wasm.find_object(picture.name, picture.width, picture.height, bytesOf(picture), object);
    return taken(found, () => ({
      ...maskOf(found.mask()),
      labels: own(found.labels()),
      count: found.count,
      notes: JSON.parse(found.notes()) as string[],
    }));
  },

  shape: (shape: ShapeName): CoreSurface => covering(wasm.Surface.built_in(shape), null),

  async mesh({ name, file, up }: SolidFile): Promise<CoreSurface> {
    const { positions, triangles, notes, up: taken } = await readMesh(name, new Uint8Array(await file.arrayBuffer()), up === undefined ? "y" : up);
    return covering(wasm.Surface.mesh(name, positions, triangles, notes), taken);
  },

  pattern: (pattern: PatternName, sidePx: number): Ink => ink(wasm.pattern(pattern, sidePx)),

  async start(work: Exclude<Work, { job: "fill" }>, settings: SettingValues, from: Bytes | null, { tell, note }: Ears): Promise<CoreRun> {
    const given = JSON.stringify(settings);
    if (work.job === "stroke") {
      const subject = sitter(work.subject);
      try {
        return pulled(await (from ? wasm.Run.resume_stroke(subject, given, from, tell, note) : wasm.Run.start_stroke(subject, given, tell, note)));
      } finally {
        subject.free();
      }
    }
    const drawings = set(work.drawings);
    try {
      return pulled(await (from ? wasm.Run.resume(drawings, given, from, tell, note) : wasm.Run.start(drawings, given, tell, note)));
    } finally {
      drawings.free();
    }
  },

  open: (given: { code: string } | { file: Bytes; name: string }): Finished =>
    taken("code" in given ? wasm.Made.from_share_code(given.code) : wasm.Made.from_file(given.name, given.file), finished),

  export: (file: Bytes, format: ExportFormat, view: string): Bytes => own(wasm.export_file(file, format, view)),
};

let loading: Promise<typeof core> | null = null;

/** The core once it is loaded; every call waits for it, and hears why it cannot be. */
export function loaded(): Promise<typeof core> {
  return (loading ??= load());
}

function set(drawings: readonly Drawing[]): wasm.DrawingSet {
  const set = new wasm.DrawingSet();
  try {
    for (const { name, width, height, ink } of drawings) set.add(name, width, height, ink);
  } catch (error) {
    set.free();
    throw error;
  }
  return set;
}

function sitter({ picture, mask, depth }: Sitter): wasm.Subject {
  const subject = new wasm.Subject(picture.name, picture.width, picture.height, bytesOf(picture));
  try {
    if (mask) subject.set_mask(mask.width, mask.height, mask.ink);
    if (depth) subject.set_depth(depth.name, depth.width, depth.height, bytesOf(depth), depth.measured ?? false);
  } catch (error) {
    subject.free();
    throw error;
  }
  return subject;
}

function bytesOf({ rgba }: Picture): Uint8Array {
  return new Uint8Array(rgba.buffer, rgba.byteOffset, rgba.byteLength);
}

function covering(surface: wasm.Surface, up: Up | null): CoreSurface {
  return {
    found: () => ({
      positions: surface.positions() as FoundSurface["positions"],
      indices: surface.indices() as FoundSurface["indices"],
      triangles: surface.triangle_count,
      notes: JSON.parse(surface.notes()) as string[],
      up,
    }),
    dress(style) {
      if (!style) surface.clear_style();
      else if (typeof style === "string") surface.set_pattern(style);
      else surface.set_style(style.name, style.width, style.height, bytesOf(style));
    },
    curve: (settings, tell) => shape(surface.curve(JSON.stringify(settings), tell)),
    async start(settings, from, { tell, note }) {
      const given = JSON.stringify(settings);
      return pulled(await (from ? wasm.Run.resume_fill(surface, given, from, tell, note) : wasm.Run.start_fill(surface, given, tell, note)));
    },
    export: (file, format, view) => own(surface.export_file(file, format, view)),
    free: () => surface.free(),
  };
}

function pulled(run: wasm.Run): CoreRun {
  const frame = () => ({ wire: shape(run.wire()), iteration: run.iteration, iterations: run.iterations, loss: run.loss });
  return {
    get iteration() {
      return run.iteration;
    },
    get iterations() {
      return run.iterations;
    },
    step: async (count) => JSON.parse(await run.step(count)) as RunEvent[],
    place: () => JSON.parse(run.place()) as Place,
    frame,
    snapshot: () => ({ ...frame(), checkpoint: new Blob([own(run.checkpoint())]) }),
    targets: () => targets(run),
    finish: () => taken(run.finish(), finished),
    free: () => run.free(),
  };
}

function finished(made: wasm.Made): Finished {
  return {
    wire: shape(made.wire()),
    views: JSON.parse(made.views()) as View[],
    targets: targets(made),
    shown: Array.from({ length: made.shown_count }, (_, index) => ink(made.shown(index))),
    measures: JSON.parse(made.result()) as Measures,
    faults: JSON.parse(made.faults()) as Faults,
    file: own(made.file()),
    code: made.share_code(),
  };
}

function shape(wire: wasm.WireData): OwnShape {
  return taken(wire, () => ({ closed: wire.closed, knots: wire.knots(), controlPoints: wire.control_points() }) as OwnShape);
}

function ink(ink: wasm.Ink): Ink {
  return taken(ink, () => ({ width: ink.width, height: ink.height, ink: own(ink.bytes()) }));
}

function maskOf(mask: wasm.Ink): Pick<FoundObject, "width" | "height" | "mask"> {
  const { ink: bytes, ...size } = ink(mask);
  return { ...size, mask: bytes };
}

function targets(of: { target_count: number; target(index: number): wasm.ViewTarget }): Target[] {
  return Array.from({ length: of.target_count }, (_, index) =>
    taken(of.target(index), (target) => ({ ...(JSON.parse(target.placed()) as Placed), ...ink(target.ink()) })),
  );
}

function taken<T extends { free(): void }, R>(handle: T, read: (handle: T) => R): R {
  try {
    return read(handle);
  } finally {
    handle.free();
  }
}

/** The binding copies out of wasm memory, so the buffer is a plain one. */
function own(copied: Uint8Array): Bytes {
  return copied as Bytes;
}
