/** The icons on the shelf: a large part of the page, so only to be imported when somebody opens the shelf. */

import nodes from "lucide-static/icon-nodes.json";
import licence from "lucide-static/LICENSE?raw";
import tags from "lucide-static/tags.json";
import { PAPER_PX } from "../../paper";
import type { Icon } from "./shelf";

/** Side of the square that the shapes are in. */
export const ICON_SIDE = 24;

/** Shapes to be stroked: a kind of SVG element and its attributes, as text. */
export type Shape = readonly [kind: string, attributes: Readonly<Record<string, string>>];

export interface ShelfIcon extends Icon {
  readonly shapes: readonly Shape[];
}

export { licence };

const tagsOf: Readonly<Record<string, readonly string[]>> = tags;

// The file is as the type says; what a compiler makes of its 1,900 literals is not.
export const icons: readonly ShelfIcon[] = Object.entries(nodes as unknown as Readonly<Record<string, readonly Shape[]>>).map(
  ([name, shapes]) => ({ name, shapes, tags: (tagsOf[name] ?? []).map((tag) => tag.toLowerCase()) }),
);

/** The icon as ink of the sheet's size; the width is in units of its square. */
export function iconInk({ shapes }: ShelfIcon, strokeWidth: number): Uint8Array<ArrayBuffer> {
  const context = new OffscreenCanvas(PAPER_PX, PAPER_PX).getContext("2d", { willReadFrequently: true })!;
  context.scale(PAPER_PX / ICON_SIDE, PAPER_PX / ICON_SIDE);
  context.lineWidth = strokeWidth;
  context.lineCap = "round";
  context.lineJoin = "round";
  for (const shape of shapes) {
    const path = pathOf(shape);
    context.stroke(path);
    if (shape[1]["fill"] === "currentColor") context.fill(path);
  }
  const { data } = context.getImageData(0, 0, PAPER_PX, PAPER_PX);
  const ink = new Uint8Array(PAPER_PX ** 2);
  for (let i = 0; i < ink.length; i++) ink[i] = data[4 * i + 3]!;
  return ink;
}

function pathOf([kind, attributes]: Shape): Path2D {
  const number = (name: string): number => Number(attributes[name] ?? 0);
  const path = new Path2D(kind === "path" ? attributes["d"] : undefined);
  switch (kind) {
    case "circle":
      path.arc(number("cx"), number("cy"), number("r"), 0, 2 * Math.PI);
      break;
    case "ellipse":
      path.ellipse(number("cx"), number("cy"), number("rx"), number("ry"), 0, 0, 2 * Math.PI);
      break;
    case "line":
      path.moveTo(number("x1"), number("y1"));
      path.lineTo(number("x2"), number("y2"));
      break;
    case "rect":
      path.roundRect(number("x"), number("y"), number("width"), number("height"), number("rx") || number("ry"));
      break;
    case "polyline":
    case "polygon": {
      const points = (attributes["points"] ?? "").trim().split(/[\s,]+/u).map(Number);
      for (let i = 0; i < points.length; i += 2) path.lineTo(points[i]!, points[i + 1]!);
      if (kind === "polygon") path.closePath();
      break;
    }
  }
  return path;
}
