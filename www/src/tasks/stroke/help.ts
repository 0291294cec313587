import { msg } from "@lit/localize";
import { html } from "lit";

export const help = html`
  <b>${msg("One picture.")}</b> ${msg("Give one picture with something in it: a cat, a face, a word. The app finds what stands out, guesses how it is rounded, and bends one wire that draws it from the front and still makes sense from the side. Fewer control points make it more abstract. Of a photograph it draws the outline and the few lines that matter; where it asks which thing is meant, drag a box round it, or press Mark and draw on it.")}
`;
