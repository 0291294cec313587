/** What the page's elements need of a task, besides what state does. */

import type { TemplateResult } from "lit";
import type { BodyShape } from "#sculpture/scene/body";
import type { ViewName } from "#sculpture/scene/stage";
import type { Task, Taker } from "../../state/contract/task";
import type { Made, Studio, StudioState } from "../../state/studio";
import type { Heading } from "../../view/heading";
import type { icons } from "./icons";

/** Words for what elements have to say. */
export interface PageWords {
  /** On its tab, and what the tab says of itself. */
  readonly tab: string;
  readonly title: string;
  /** Of the column where things are given. */
  readonly panel: string;
  /** What may be dropped. */
  readonly drops: string;
  /** The button that starts a run. */
  readonly run: string;
  /** The button beside it: to give something else than the example, or than what is there. */
  readonly own: { readonly icon: keyof typeof icons; readonly instead: string; readonly again: string };
  /** Over what the wire amounts to; and what that is for the example. */
  readonly result: string;
  readonly example: string;
  /** What the stage shows instead of a wire: where one was made of something else, and where there is none. */
  readonly planned?: { readonly made: string; readonly none: string };
}

/** How the stage shows its wires. */
export interface StageWords {
  /** Buttons to look from, and what there is to see from there. */
  readonly views: Readonly<Partial<Record<ViewName, string>>>;
  /** Where the camera goes when a wire is done: from picture to picture, or once round. */
  readonly tour: readonly (ViewName | Heading)[];
  /** The setting that says whether lines on the far side of what the wire covers are seen. */
  readonly farSide?: string;
}

/** The page, for a task's elements. */
export interface Page {
  readonly studio: Studio;
  readonly state: StudioState;
  /** What is open over the stage, in the task's own words; null for nothing. */
  readonly editing: unknown;
  edit(what: unknown): void;
  /** Brings the column where things are given to the fore; resolves when it is there. */
  toPads(): Promise<ParentNode>;
}

/** A number about a wire. */
export type Figure = readonly [name: string, value: string];

/** A task's elements, which come when it is first looked at. */
export interface TaskParts {
  /** Where things are given: a column of a desk, a sheet on a phone. */
  pads(page: Page): TemplateResult;
  /** What matters most, near Run. */
  choices(page: Page): TemplateResult;
  /** What lies over the stage while something is open. */
  editor?(page: Page): TemplateResult | null;
  /** For a person who wants to give something of their own. */
  own(page: Page): void;
  /** Pictures of the wire besides those of the match; elements of the class `pictures` are told wires and colours. */
  result?(state: StudioState, measured: Made | null): TemplateResult;
  /** Before the figures that every wire has. */
  figures?(measured: Made | null): readonly Figure[];
  /** What the wire on the stage covers. */
  body?(state: StudioState): BodyShape | null;
}

export interface PageTask<Given = unknown, Passing extends object = object, Takes extends Taker = Taker> extends Task<Given, Passing, Takes> {
  readonly page: PageWords;
  readonly stage: StageWords;
  /** Settings with a control of their own where things are given, or near Run. */
  readonly elsewhere: readonly string[];
  /** What of what is given no link carries, a sentence, or empty. */
  stays?(given: Given): string;
  parts(): Promise<{ readonly parts: TaskParts }>;
  /** What it is, and how it goes, in a paragraph. */
  help(): Promise<{ readonly help: TemplateResult }>;
}
