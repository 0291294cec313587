/** What the page shows of one picture. */

import { msg } from "@lit/localize";
import { html, type LitElement } from "lit";
import { redo, undo } from "../../../state/actions/actions";
import { givenFor, passingOf } from "../../../state/contract/state";
import type { Page, TaskParts } from "../../../ui/shared/page-task";
import { stroke } from "../task";
import type { MaskStroke } from "../given";
import { hintsWithBox, hintsWithMark } from "../hints";
import "./stroke-choices";
import type { SubjectEvents } from "./subject-events";
import "./subject-pad";
import "./turned-views";

type Told<Kind extends keyof SubjectEvents> = CustomEvent<SubjectEvents[Kind]>;

const BRUSH = "brush";

/** What both the pad and the editor tell of where a person points. */
function point({ studio }: Page, event: Told<"give-box"> | Told<"mark"> | Told<"clear-marks">): void {
  const taker = studio.taker(stroke);
  const { detail } = event;
  if (!detail) void taker.point(msg("Clear the marks"), (subject) => ({ ...subject, marks: [] }));
  else if ("box" in detail) void taker.point(detail.box ? msg("Put a box round the object") : msg("Remove the box"), (subject) => hintsWithBox(subject, detail.box));
  else void taker.point(detail.mark.adds ? msg("Mark the object") : msg("Mark what is not the object"), (subject) => hintsWithMark(subject, detail.mark), true);
}

export const parts: TaskParts = {
  pads(page) {
    const { studio, state, edit } = page;
    const taker = studio.taker(stroke);
    const { busy, problem, note } = passingOf(state, stroke);
    return html`<subject-pad
      .subject=${givenFor(state, stroke)}
      .busy=${busy}
      .problem=${problem}
      .note=${note}
      .locked=${state.phase !== "idle"}
      @give=${({ detail }: Told<"give">) => void taker.give(detail.file, detail.name)}
      @choose-object=${({ detail }: Told<"choose-object">) => void taker.chooseObject(detail.object)}
      @give-box=${(event: Told<"give-box">) => point(page, event)}
      @clear-marks=${(event: Told<"clear-marks">) => point(page, event)}
      @clear-subject=${() => taker.clear()}
      @open-brush=${() => open(edit)}
      @give-depth=${({ detail }: Told<"give-depth">) => void taker.giveDepth(detail.file, detail.name)}
      @clear-depth=${() => taker.clearDepth()}
    ></subject-pad>`;
  },
  choices: ({ studio, state }) => html`<stroke-choices .studio=${studio} .state=${state}></stroke-choices>`,
  editor(page) {
    const { studio, state, editing, edit } = page;
    const subject = givenFor(state, stroke);
    if (editing !== BRUSH || !subject) return null;
    const passing = passingOf(state, stroke);
    const foresee = (mark: MaskStroke) => studio.taker(stroke).foresee((subject) => hintsWithMark(subject, mark));
    return html`<mask-editor
      .subject=${subject}
      .busy=${passing.busy}
      .problem=${passing.problem}
      .foresee=${foresee}
      .locked=${state.phase !== "idle"}
      .undo=${state.undo}
      .redo=${state.redo}
      @give-box=${(event: Told<"give-box">) => point(page, event)}
      @mark=${(event: Told<"mark">) => point(page, event)}
      @clear-marks=${(event: Told<"clear-marks">) => point(page, event)}
      @paint=${({ detail }: Told<"paint">) => studio.taker(stroke).paint(detail.strokes)}
      @undo=${() => studio.act(undo)}
      @redo=${() => studio.act(redo)}
      @close-editor=${() => edit(null)}
    ></mask-editor>`;
  },
  own: (page) => void startOver(page),
  result: () => html`<turned-views class="pictures"></turned-views>`,
};

/** The editor is loaded when it is first wanted. */
function open(edit: (what: unknown) => void): void {
  void import("./mask-editor");
  edit(BRUSH);
}

/** An empty pad, with all the ways to fill it. */
async function startOver({ studio, toPads }: Page): Promise<void> {
  studio.taker(stroke).clear();
  const pad = (await toPads()).querySelector<LitElement>("subject-pad");
  await pad?.updateComplete;
  pad?.renderRoot.querySelector<HTMLElement>(".ways button")?.focus();
}
