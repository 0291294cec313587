/** Hands on the wire as a tool of the page. */

import { html } from "lit";
import type { OpenTool } from "../stage/tool";
import { Hands } from "./hands";
import "./hands-panel";

export const open: OpenTool = (studio, stage) => {
  const hands = new Hands(studio, stage);
  return { panel: (state) => html`<hands-panel .hands=${hands} .state=${state}></hands-panel>` };
};
