import { msg } from "@lit/localize";
import { html } from "lit";

export const help = html`
  <b>${msg("Three views.")}</b> ${msg("Put a picture on each pad: draw it, type a word, choose an icon, or drop a file. Press Run, and one continuous wire bends itself until its shadows from the front, the side and above are your three drawings. What no wire can show in all views at once is marked in amber before you run, with a click to make it better. Where you look for an icon, its word can also pull the wire, with a drawing or without: an experiment. Turn the room to see the pictures click into place.")}
`;
