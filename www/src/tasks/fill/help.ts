import { msg } from "@lit/localize";
import { html } from "lit";

export const help = html`
  <b>${msg("A shape.")}</b> ${msg("Choose a shape or drop a mesh, and one closed wire covers it all over. A style bends and thickens it: petals, waves, or a picture of your own. What is behind the shape is hidden, so that the lines stay clear.")}
`;
