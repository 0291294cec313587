/** A drawing of the wire for browsers that cannot draw in 3D: its samples, projected, as lines as thick as they are. */

import { svg } from "./dom";
import { axesOf, directionOf, type Vantage } from "../scene/orbit";
import { sampleWire, samplesPerSpan, type WireShape } from "../scene/shape";

const SAMPLES = 1200;
/** Widths are told apart in so many steps, so that a wire is few paths. */
const WIDTHS = 12;
const MARGIN = 0.06;

/** Straight from a vantage, in the colour that its text has. */
export function drawingOf(wire: WireShape, vantage: Vantage): SVGSVGElement {
  const { points, strips } = sampleWire(wire, samplesPerSpan(wire, SAMPLES));
  const { right, up } = axesOf(directionOf(vantage));
  const along = (axis: readonly number[], k: number): number => axis[0]! * points[4 * k]! + axis[1]! * points[4 * k + 1]! + axis[2]! * points[4 * k + 2]!;
  const place = (k: number): readonly [number, number] => [along(right, k), -along(up, k)];
  let [low, high] = [[Infinity, Infinity], [-Infinity, -Infinity]];
  let widest = 1e-6;
  const lines: { readonly from: number; readonly to: number }[] = [];
  for (const { first, last, closed } of strips) {
    for (let k = first; k <= last; k++) {
      const at = place(k);
      low = low.map((x, c) => Math.min(x, at[c]!));
      high = high.map((x, c) => Math.max(x, at[c]!));
      widest = Math.max(widest, points[4 * k + 3]!);
      if (k < last || closed) lines.push({ from: k, to: k < last ? k + 1 : first });
    }
  }
  const paths = Array.from({ length: WIDTHS }, () => "");
  const number = (x: number): string => x.toFixed(4);
  for (const { from, to } of lines) {
    const width = Math.min(WIDTHS - 1, Math.floor((points[4 * from + 3]! / widest) * WIDTHS));
    paths[width] += `M${place(from).map(number).join(" ")}L${place(to).map(number).join(" ")}`;
  }
  const [x, y] = low.map((least) => (Number.isFinite(least) ? least - MARGIN : -1)) as [number, number];
  const size = [0, 1].map((c) => Math.max(0.2, high[c]! - low[c]! + 2 * MARGIN)).map((side) => (Number.isFinite(side) ? side : 2));
  const drawing = svg("svg", { viewBox: [x, y, ...size].map(number).join(" "), fill: "none", stroke: "currentColor", "stroke-linecap": "round", "aria-hidden": "true" });
  paths.forEach((d, width) => d && drawing.append(svg("path", { d, "stroke-width": number(((2 * (width + 0.5)) / WIDTHS) * widest) })));
  return drawing;
}
