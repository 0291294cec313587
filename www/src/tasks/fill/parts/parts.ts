/** What the page shows of a mesh and its style. */

import { msg } from "@lit/localize";
import { html } from "lit";
import { deskOf } from "../../../state/keeping/document";
import { givenFor, passingOf } from "../../../state/contract/state";
import "../../../ui/run/run-choices";
import { DASH } from "../../../ui/run/figures";
import type { TaskParts } from "../../../ui/shared/page-task";
import { meshKey, type Cover } from "../given";
import { fill } from "../task";
import { worldLength } from "../verdict";
import "./covered-views";
import "./fill-choices";
import "./shape-pad";
import type { ShapePad } from "./shape-pad";
import "./style-shelf";

export const parts: TaskParts = {
  pads: ({ studio, state }) => html`<shape-pad .studio=${studio} .state=${state}></shape-pad>
    <style-shelf .studio=${studio} .state=${state}></style-shelf>
    <fill-choices .studio=${studio} .state=${state}></fill-choices>`,
  choices: ({ studio, state }) => html`<run-choices .studio=${studio} .state=${state}></run-choices>`,
  own: ({ toPads }) => void toPads().then((pads) => pads.querySelector<ShapePad>("shape-pad")?.openFile()),
  result: ({ doc }, measured) => html`<covered-views class="pictures" .made=${deskOf(doc).made} ?past=${!measured}></covered-views>`,
  /** Shares of the shape's size. */
  figures(measured) {
    const surface = measured?.finished.measures.surface;
    return [
      [msg("99 of 100 spots are nearer than"), surface ? worldLength(surface.p99 * surface.spacing) : DASH],
      [msg("Off the surface, on average"), surface ? worldLength(surface.drift_mean) : DASH],
    ];
  },
  /** While somebody looks back at a run over another mesh, that is not at hand. */
  body(state) {
    const now = givenFor(state, fill);
    const cover = state.looking !== null && state.track ? (state.track.given as Cover) : now;
    return cover && now && meshKey(cover.mesh) === meshKey(now.mesh) ? passingOf(state, fill).surface : null;
  },
};
