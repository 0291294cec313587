/** The wasm module in the page's own words. Imported by the worker and by nothing else. */

import type { WireShape } from "../embed/shape";
import type { ExportFormat, Finished, Frame, Ink, Measures, Picture, SettingRow, SettingValues, Target, View } from "./protocol";
import init, * as wasm from "./wasm/wire4d";
import moduleUrl from "./wasm/wire4d_bg.wasm?url";

export interface CoreRun {
  /** Up to `count` steps; where it is now. */
  step(count: number): { iteration: number; iterations: number };
  frame(): Frame;
  targets(): Target[];
  /** Ends the run with the best wire so far. */
  finish(): CoreSculpture;
  free(): void;
}

export interface CoreSculpture {
  show(): Finished;
  export(format: ExportFormat): Uint8Array<ArrayBuffer>;
  share(): string;
  free(): void;
}

const ready = init({ module_or_path: moduleUrl });

export const core = {
  ready,

  settings(): SettingRow[] {
    return JSON.parse(wasm.settings_table()) as SettingRow[];
  },

  read(picture: Picture, settings: SettingValues): Ink {
    const ink = wasm.read_ink(picture.name, picture.width, picture.height, bytes(picture), JSON.stringify(settings));
    return taken(ink, plain);
  },

  start(
    pictures: readonly Picture[],
    settings: SettingValues,
    tell: (words: string, share: number) => void,
    note: (words: string) => void,
  ): CoreRun {
    const set = new wasm.PictureSet();
    for (const picture of pictures) set.add(picture.name, picture.width, picture.height, bytes(picture));
    return wrapRun(wasm.Run.start(set, JSON.stringify(settings), tell, note));
  },

  open(code: string): CoreSculpture {
    return wrapSculpture(wasm.Made.from_share_code(code));
  },
};

function wrapRun(run: wasm.Run): CoreRun {
  return {
    step: (count) => {
      run.step(count);
      return { iteration: run.iteration, iterations: run.iterations };
    },
    frame: () => ({ wire: taken(run.wire(), shape), iteration: run.iteration, iterations: run.iterations, loss: run.loss }),
    targets: () => targets(run),
    finish: () => wrapSculpture(run.finish()),
    free: () => run.free(),
  };
}

function wrapSculpture(made: wasm.Made): CoreSculpture {
  return {
    show: () => ({
      wire: taken(made.wire(), shape),
      views: JSON.parse(made.views()) as View[],
      targets: targets(made),
      measures: JSON.parse(made.result()) as Measures,
    }),
    export: (format) => own(format === "glb" ? made.glb() : made.wire_json()),
    share: () => made.share_code(),
    free: () => made.free(),
  };
}

function shape(wire: wasm.WireData): WireShape {
  return { closed: wire.closed, knots: wire.knots(), controlPoints: wire.control_points() };
}

function plain(ink: wasm.Ink): Ink {
  return { width: ink.width, height: ink.height, ink: own(ink.bytes()) };
}

function targets(of: { target_count: number; target(index: number): wasm.ViewTarget }): Target[] {
  return Array.from({ length: of.target_count }, (_, index) =>
    taken(of.target(index), (target) => ({
      view: JSON.parse(target.view()) as View,
      coverable: target.coverable,
      source: target.source,
      mirrored: target.mirrored,
      quarterTurns: target.quarter_turns,
      ...taken(target.ink(), plain),
    })),
  );
}

function taken<T extends { free(): void }, R>(handle: T, read: (handle: T) => R): R {
  try {
    return read(handle);
  } finally {
    handle.free();
  }
}

function bytes(picture: Picture): Uint8Array {
  return new Uint8Array(picture.rgba.buffer, picture.rgba.byteOffset, picture.rgba.byteLength);
}

/** The binding copies out of wasm memory, so the buffer is a plain one. */
function own(copied: Uint8Array): Uint8Array<ArrayBuffer> {
  return copied as Uint8Array<ArrayBuffer>;
}
