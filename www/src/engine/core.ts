/** The main wasm module in the page's own words: what tasks share of it. Only for the worker. */

import type { WireShape } from "#sculpture/scene/shape";
import type { DiffusionOptions, GuidanceDenoiser, GuidanceEncoder, GuidanceNetwork, WordsOptions } from "./wasm/wire4d";
import type { Ask } from "./crew";
import type { Backend, EditedFile, Faults, Finished, Frame, Ink, Insight, Measures, Picture, Place, Placed, RunEvent, SettingsTable, SettingsTables, Snapshot, Target, View, WireEdit } from "./protocol";
import init, * as wasm from "./wasm/wire4d";
import moduleUrl from "./wasm/wire4d_bg.wasm?url";

export type { WordsOptions };

/** A diffusion model with its encoder, where it has one, and its context of no words. */
export interface Diffusing extends Pick<DiffusionOptions, "schedule"> {
  readonly denoiser: GuidanceDenoiser;
  readonly encoder: GuidanceEncoder | null;
  readonly nothing: Float32Array;
}

/** How much of the difference between words and nothing counts: of latents as in DreamFusion, of pixels less. */
const SCALE = { latents: 100, pixels: 50 };

export type Bytes = Uint8Array<ArrayBuffer>;

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
  /** Has somebody compute views from the next step on; it changes no bit. */
  hire(ask: Ask): void;
  /** Where it is computed now: a device may be lost on the way. */
  place(): Place;
  /** Not while it steps. */
  insight(): Insight;
  frame(): Omit<Frame, "iterationsPerSecond"> & { readonly wire: OwnShape };
  snapshot(): Snapshot & { readonly wire: OwnShape };
  targets(): Target[];
  /** What people call each view: by the drawing that it shows, wherever that was arranged, or by itself. */
  pads(): readonly string[];
  /** `weight` times the loss of `networks`, for each of which `vectors` has a unit vector a view, or null. */
  guideByWords(weight: number, networks: readonly GuidanceNetwork[], vectors: readonly (readonly (Float32Array | null)[])[], options: WordsOptions): void;
  /** `weight` times the pull of a diffusion model, for which `contexts` has one a view, or null. */
  guideByDiffusion(weight: number, model: Diffusing, contexts: readonly (Float32Array | null)[]): void;
  /** Why what was to guide no longer does: a sentence each. */
  troubles(): readonly string[];
  /** The best wire so far, measured. */
  finish(): Finished;
  free(): void;
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
    module = await compiled();
    await init({ module_or_path: module });
    return core;
  } catch (error) {
    console.error(error);
    throw new Error("The engine could not be loaded. Check the connection and reload the page.");
  }
}

/** As init would: some hosts do not say that it is WebAssembly. */
async function compiled(): Promise<WebAssembly.Module> {
  const response = await fetch(moduleUrl);
  if (!response.ok) throw new Error(`${response.status} for ${moduleUrl}`);
  const again = response.clone();
  return WebAssembly.compileStreaming(response).catch(async () => WebAssembly.compile(await again.arrayBuffer()));
}

let module: WebAssembly.Module;

const core = {
  /** Compiled, for others to compute with. */
  module: () => module,

  settings: (tasks: readonly string[]): SettingsTables => Object.fromEntries(tasks.map((task) => [task, JSON.parse(wasm.settings_table(task)) as SettingsTable])),

  place: async (backend: Backend): Promise<Place> => JSON.parse(await wasm.place(backend)) as Place,

  /** The graphics card that runs are computed on, if there is one by now. */
  card: (): GPUDevice | null => wasm.graphics_device() ?? null,

  open: (given: { code: string } | { file: Bytes; name: string }): Finished =>
    "code" in given
      ? taken(wasm.Made.from_share_code(given.code), finished)
      : taken(wasm.Made.from_file(given.name, given.file), (made) => ({ ...finished(made), notes: made.notes() })),

  edited: (file: Bytes, edit: WireEdit): EditedFile => {
    const first = "index" in edit ? edit.index : "after" in edit ? edit.after : edit.from;
    const last = edit.kind === "smooth" || edit.kind === "straighten" ? edit.to : first;
    const place = edit.kind === "move" ? Float64Array.from(edit.to) : new Float64Array();
    return taken(wasm.edit_file(file, edit.kind, first, last, place), (edited) => ({ file: own(edited.file()), held: edited.held, strayed: edited.strayed }));
  },
};

let loading: Promise<typeof core> | null = null;

/** The core once it is loaded; every call waits for it, and hears why it cannot be. */
export function loaded(): Promise<typeof core> {
  return (loading ??= load());
}

export function bytesOf({ rgba }: Picture): Uint8Array {
  return new Uint8Array(rgba.buffer, rgba.byteOffset, rgba.byteLength);
}

/** A run of the core's, as it is pulled here; `names` are those of what was given for its views. */
export function pulled(run: wasm.Run, names: readonly string[] = []): CoreRun {
  const frame = () => ({ wire: shape(run.wire()), iteration: run.iteration, iterations: run.iterations, loss: run.loss });
  return {
    get iteration() {
      return run.iteration;
    },
    get iterations() {
      return run.iterations;
    },
    hire: (ask) => run.hire(ask),
    step: async (count) => JSON.parse(await run.step(count)) as RunEvent[],
    place: () => ({ ...(JSON.parse(run.place()) as Place), ...(run.workers > 1 && { workers: run.workers }) }),
    insight: () => taken(run.insight(), (insight) => ({ iteration: run.iteration, ...apart(insight) })),
    frame,
    snapshot: () => ({ ...frame(), checkpoint: new Blob([own(run.checkpoint())]) }),
    targets: () => targets(run),
    pads: () => targets(run).map(({ source, view }) => names[source ?? -1] ?? view.name),
    guideByWords: (weight, networks, vectors, options) => run.guideByWords("words", weight, networks, vectors, options),
    guideByDiffusion(weight, { denoiser, encoder, schedule, nothing }, contexts) {
      const told = contexts.map((context) => context && { context, nothing });
      run.guideByDiffusion("words", weight, denoiser, encoder, told, { schedule, scale: encoder ? SCALE.latents : SCALE.pixels });
    },
    troubles: () => run.guidanceTroubles(),
    finish: () => taken(run.finish(), finished),
    free: () => run.free(),
  };
}

function apart(insight: wasm.Insight): Omit<Insight, "iteration"> {
  const losses = insight.losses();
  const { view_count: views } = insight;
  return {
    wire: shape(insight.wire()),
    pulls: insight.terms().map((name, term) => ({ name, ofView: term < views, loss: losses[term]!, gradient: insight.gradient(term) })),
    views: Array.from({ length: views }, (_, view) =>
      Array.from(insight.levels(view), (loss, level) => ({ loss, seen: ink(insight.seen(view, level)), wanted: ink(insight.wanted(view, level)) })),
    ),
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

export function shape(wire: wasm.WireData): OwnShape {
  return taken(wire, () => ({ closed: wire.closed, knots: wire.knots(), controlPoints: wire.control_points() }) as OwnShape);
}

export function ink(ink: wasm.Ink): Ink {
  return taken(ink, () => ({ width: ink.width, height: ink.height, ink: own(ink.bytes()) }));
}

function targets(of: { target_count: number; target(index: number): wasm.ViewTarget }): Target[] {
  return Array.from({ length: of.target_count }, (_, index) =>
    taken(of.target(index), (target) => ({ ...(JSON.parse(target.placed()) as Placed), ...ink(target.ink()) })),
  );
}

/** Reads what the core holds, and lets go of it. */
export function taken<T extends { free(): void }, R>(handle: T, read: (handle: T) => R): R {
  try {
    return read(handle);
  } finally {
    handle.free();
  }
}

/** The binding copies out of wasm memory, so the buffer is a plain one. */
export function own(copied: Uint8Array): Bytes {
  return copied as Bytes;
}
