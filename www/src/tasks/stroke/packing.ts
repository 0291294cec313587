/** How the one picture goes along in files, and comes back from them. */

import { msg } from "@lit/localize";
import { darkness, pictureOf } from "../../state/carrying/picture";
import { resized } from "../../state/carrying/resized";
import type { Packing } from "../../state/contract/task";
import { pixelsOf } from "../../state/picture/picture";
import { maskOf, type Subject } from "./given";

/** Of all that is not the object, on average: a drawing on paper has less, and is kept as it is. */
const PAPER = 24;
/** Of the lightest object, so that it stands out from white paper. */
const LEAST_INK = 64;

export const packing: Packing<Subject | null> = {
  async pack(subject) {
    if (!subject) return { drawings: [], pairs: {} };
    const { picture } = subject;
    const { width, height, ink } = darkness(await pixelsOf(picture));
    const mask = maskOf(subject);
    const object = mask && resized(mask, width, height).ink;
    return { drawings: [{ view: "front", label: picture.name, width, height, ink: object ? alone(ink, object) : ink }], pairs: {} };
  },
  async unpack({ drawings: [drawing] }) {
    return drawing ? { picture: pictureOf(drawing, drawing.label || msg("Picture")), object: 1, strokes: [], found: null, depth: null } : null;
  },
};

/** A photo without what is round the object. */
function alone(ink: Uint8Array<ArrayBuffer>, object: Uint8Array): Uint8Array<ArrayBuffer> {
  let [ground, outside] = [0, 0];
  ink.forEach((value, i) => {
    ground += value * (255 - object[i]!);
    outside += 255 - object[i]!;
  });
  if (outside === 0 || ground / outside < PAPER) return ink;
  return ink.map((value, i) => Math.round(((LEAST_INK + (value * (255 - LEAST_INK)) / 255) * object[i]!) / 255));
}
