/** How a shape and its style go along in files, by name or as a picture, and come back from them. A mesh is too large. */

import { msg } from "@lit/localize";
import { darkness, pictureOf } from "../../state/carrying/picture";
import type { Packing } from "../../state/contract/task";
import { pixelsOf } from "../../state/picture/picture";
import { address, type Cover } from "./given";

/** What the picture of a style goes by, in place of a view. */
const STYLE = "style";

export const packing: Packing<Cover | null> = {
  async pack(cover) {
    const style = cover?.style;
    const drawings = style && typeof style !== "string" ? [{ view: STYLE, label: style.name, ...darkness(await pixelsOf(style)) }] : [];
    return { drawings, pairs: address.write(cover) };
  },
  async unpack({ drawings, pairs }) {
    const cover = address.read(pairs);
    const drawn = drawings.find(({ view }) => view === STYLE);
    return cover && drawn ? { ...cover, style: { ...pictureOf(drawn, drawn.label || msg("Picture")), key: crypto.randomUUID() } } : cover;
  },
};
