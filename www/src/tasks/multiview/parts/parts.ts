/** What the page shows of several drawings. */

import { html } from "lit";
import type { TaskParts } from "../../../ui/shared/page-task";
import "../../../ui/run/run-choices";
import { givenFor } from "../../../state/contract/state";
import { deskOf } from "../../../state/studio";
import { SLOTS } from "../given";
import { multiview } from "../task";
import "./bend-choice";
import "./drawing-pad";
import type { EditRequest } from "./drawing-pad";
import "./remedy-list";

const isRequest = (editing: unknown): editing is EditRequest => editing !== null;

export const parts: TaskParts = {
  pads: ({ studio, state, edit }) => html`${SLOTS.map(
      (slot) => html`<drawing-pad
        .studio=${studio}
        .state=${state}
        .slotName=${slot}
        @open-editor=${({ detail }: CustomEvent<EditRequest>) => open(edit, detail)}
      ></drawing-pad>`,
    )}
    <remedy-list .studio=${studio} .state=${state}></remedy-list>`,
  choices: ({ studio, state }) => html`<run-choices .studio=${studio} .state=${state}><bend-choice .studio=${studio} .state=${state}></bend-choice></run-choices>`,
  editor: ({ studio, state, editing, edit }) =>
    isRequest(editing)
      ? html`<pad-editor .studio=${studio} .state=${state} .slot=${editing.slot} .tab=${editing.tab} @close-editor=${() => edit(null)}></pad-editor>`
      : null,
  own({ studio, state, edit }) {
    const { words = {} } = deskOf(state.doc, multiview.name).guide ?? {};
    if (!multiview.isBlank(givenFor(state, multiview)) || Object.values(words).some(Boolean)) studio.taker(multiview).clear();
    open(edit, { slot: "front", tab: "draw" });
  },
};

/** The editor is loaded when it is first wanted. */
function open(edit: (what: unknown) => void, request: EditRequest): void {
  void import("./pad-editor");
  edit(request);
}
