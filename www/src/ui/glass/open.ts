/** The glass box as a tool of the page. */

import { html } from "lit";
import type { OpenTool } from "../stage/tool";
import { Glass } from "./glass";
import "./glass-panel";
import "./wire-strip";

export const open: OpenTool = (studio, stage) => {
  const glass = new Glass(studio, stage);
  return {
    panel: (state, narrow) => html`<glass-panel .glass=${glass} .state=${state} ?narrow=${narrow}></glass-panel>`,
    under: (state) => html`<wire-strip .glass=${glass} .state=${state}></wire-strip>`,
  };
};
