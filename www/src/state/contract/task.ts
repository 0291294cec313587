/**
 * What a task is to the rest of the page: all in which tasks differ, and nothing else. Each has a folder in `tasks/`; one
 * line in `tasks/registry.ts` makes it known.
 */

import type { EngineClient } from "../../engine/client";
import type { ExportArguments, Guide, Ink, ViewMeasures } from "../../engine/protocol";
import type { Made } from "../keeping/document";
import type { Form } from "../keeping/keep";
import type { Bench } from "./bench";
import type { TaskState } from "./state";

/** Words for what state has to say. */
export interface TaskWords {
  /** What is given, as in "Bring back the picture of the run". */
  readonly given: string;
  /** What a run is at when it begins: "Looking at the picture". */
  readonly looking: string;
  /** What a wire needs, a sentence, and what to do about it, another. */
  readonly needs: string;
  readonly remedy: string;
  /** To somebody who dropped text. */
  readonly text: string;
}

/** What is shown to those who have given a task nothing yet. */
export interface Example<Given> {
  /** The wire, as a share code. */
  readonly code: string;
  /** What it was made of. */
  readonly given: Given;
  /** How well it matches: the core cannot measure that without pictures, and a code has none. */
  readonly measured: readonly ViewMeasures[];
}

/** What files bring: meshes only to a task that takes them. */
export interface Files {
  readonly pictures: readonly File[];
  readonly meshes: readonly File[];
}

/** What lives of a task as long as the page: it takes what people bring. */
export interface Taker<Given = unknown> {
  /** Files from anywhere. */
  take(files: Files): Promise<void>;
  /** Takes away what is given. */
  clear(): void;
  /** What an example came without, and the core is to find. */
  complete?(given: Given): void;
  /** A wire from elsewhere is on its way, of what is there now; what changes from now on is the person's doing. */
  awaits?(): void;
  /** What a wire was made of, as far as it is known or still there. */
  madeOf?(made: Made): Given | null;
  /** The wire as an SVG that leaves out what cannot be seen; null where all of it can. */
  exportSeen?(made: Made, how: ExportArguments): Promise<Uint8Array<ArrayBuffer>> | null;
}

export interface Task<Given = unknown, Passing extends object = object, Takes extends Taker = Taker> extends TaskState<Given, Passing> {
  readonly words: TaskWords;
  /** What of files it takes. */
  readonly takes: { readonly pictures: number; readonly meshes: boolean };
  /** Settings that say what is made, not how long it takes: a preset leaves them alone, and so it does whole groups. */
  readonly keeps: { readonly settings: readonly string[]; readonly groups: readonly string[] };
  /** Names of the views that have a picture to be like, in order. */
  readonly compared: readonly string[];
  /** How what is given is kept in this browser. */
  readonly form: Form<Given>;
  /** What of it an address can carry. */
  readonly address?: AddressForm<Given>;
  /** Comes when a file is saved or opened. */
  packing(): Promise<Packing<Given>>;
  isBlank(given: Given): boolean;
  /** Whether a wire can be made of it and of what guides. `closely` when a run is to begin: at a glance, it is asked at every change. */
  suffices(given: Given, guide: Guide | null, closely?: boolean): boolean;
  /** The same without its last picture, where a wire can be made of what is left; null where not. */
  fewer?(given: Given): Given | null;
  /** What people call what they gave. */
  labels(given: Given): readonly string[];
  /** What is given, and what guides, as the task's engine takes it. */
  work(given: Given, guide: Guide | null): Promise<unknown>;
  example?(engine: EngineClient): Promise<Example<Given>>;
  /** What a wire of a run amounts to, and what to try. */
  verdict(made: Made): string;
  open(bench: Bench): Takes;
}

/** What is given as files carry it. */
export interface Packed {
  readonly drawings: readonly PackedDrawing[];
  /** Names and words, as in an address. */
  readonly pairs: Readonly<Record<string, string>>;
}

export interface PackedDrawing extends Ink {
  /** The view that it is for, or what else the task calls so. */
  readonly view: string;
  /** What a person calls it. */
  readonly label: string;
}

/** How what is given goes along in files, and comes back from them. */
export interface Packing<Given> {
  pack(given: Given): Promise<Packed>;
  /** Null where that is nothing to make a wire of. */
  unpack(packed: Packed): Promise<Given | null>;
}

/** How an address names what is given: pairs of names and words. */
export interface AddressForm<Given> {
  readonly keys: readonly string[];
  write(given: Given): Readonly<Record<string, string>>;
  /** What those pairs name; null where that is nothing. */
  read(pairs: Readonly<Record<string, string>>): Given | null;
}
