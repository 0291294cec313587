/** The shapes by formula, as small drawings: clay with a few lines of the wire. */

import { html, svg, type TemplateResult } from "lit";
import type { ShapeName } from "../protocol";

type Point = readonly [x: number, y: number];

const rounded = (value: number): number => Math.round(10 * value) / 10;
const path = (points: readonly Point[]): string => points.map(([x, y], i) => `${i ? "L" : "M"}${rounded(x)} ${rounded(y)}`).join("");
/** The front half of a ring that goes round an upright axis. */
const band = (y: number, rx: number, ry: number, cx = 24): string => `M${cx - rx} ${y}A${rx} ${ry} 0 0 0 ${cx + rx} ${y}`;

const clay = (d: string) => svg`<path class="clay" d=${d} />`;
const lines = (...d: readonly string[]) => svg`<path class="wire" d=${d.join("")} />`;

function sphere() {
  const at = (degrees: number): string => {
    const [y, r] = [24 - 19 * Math.sin((degrees * Math.PI) / 180), 19 * Math.cos((degrees * Math.PI) / 180)];
    return band(rounded(y), rounded(r), rounded(0.28 * r));
  };
  return [svg`<circle class="clay" cx="24" cy="24" r="19" />`, lines(...[56, 34, 13, -8, -29, -50].map(at))];
}

function torus() {
  const ring = "M3 24a21 15 0 1 0 42 0a21 15 0 1 0-42 0M15.5 22a8.5 4.5 0 0 1 17 0a8.5 4.5 0 0 1-17 0";
  const meridians = Array.from({ length: 14 }, (_, i): string => {
    const angle = (2 * Math.PI * (i + 0.5)) / 14;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const [inner, outer] = [[24 + 8.5 * c, 22 + 4.5 * s], [24 + 21 * c, 24 + 15 * s]] as const;
    const middle = [24 + 14.5 * c, 20 + 9.5 * s] as const;
    return `M${inner.map(rounded).join(" ")}Q${middle.map(rounded).join(" ")} ${outer.map(rounded).join(" ")}`;
  });
  return [svg`<path class="clay" fill-rule="evenodd" d=${ring} />`, lines(...meridians)];
}

/** A trefoil in pieces, the far ones first, so that it crosses over itself. */
function knot() {
  const at = (t: number): Point => [24 + 6.7 * (Math.sin(t) + 2 * Math.sin(2 * t)), 23 - 6.7 * (Math.cos(t) - 2 * Math.cos(2 * t))];
  const pieces = 36;
  const piece = (i: number): Point[] => [-0.08, 0.25, 0.5, 0.75, 1.08].map((k) => at((2 * Math.PI * (i + k)) / pieces));
  const height = (i: number): number => -Math.sin((6 * Math.PI * (i + 0.5)) / pieces);
  const order = Array.from({ length: pieces }, (_, i) => i).toSorted((a, b) => height(a) - height(b));
  return order.map((i) => {
    const d = path(piece(i));
    return svg`<path class="edge" d=${d} /><path class="tube" d=${d} /><path class="wire" d=${d} />`;
  });
}

function vase() {
  const side = "M16 4C15 11 20 12 19 17C17 22 9 24 9 33C9 40 14 43 16 45L32 45C34 43 39 40 39 33C39 24 31 22 29 17C28 12 33 11 32 4A8 2.2 0 0 1 16 4";
  return [
    clay(side),
    svg`<ellipse class="rim" cx="24" cy="4" rx="8" ry="2.2" />`,
    lines(band(11, 5.6, 1.5), band(18, 5.2, 1.4), band(25, 11.8, 2.6), band(32, 15, 3.2), band(39, 13.2, 2.8)),
  ];
}

function creature() {
  const limbs: readonly (readonly [d: string, width: number])[] = [
    ["M12 27L10 42M17 29L18 42M31 29L30 42M35 27L37 42", 6],
    ["M13 24C18 21 29 21 34 24", 15],
    ["M34 22L40 14", 9],
    ["M40 13L43 14", 8],
    ["M8 22C4 20 4 15 5 12", 3.5],
    ["M37 9L36 6", 3.5],
  ];
  return [
    ...limbs.map(([d, width]) => svg`<path class="limb" stroke-width=${width} d=${d} />`),
    lines("M9 20c3 4 3 8 1 11M15 17c3 4 3 10 1 14M21 16.5c3 4 3 10 1 13M27 16.5c3 4 3 10 1 13M33 18c3 3 3 8 1 12M37 13c2 1 4 4 4 6M8 37h5M15.5 37h5M28 37h5M34.5 37h5"),
  ];
}

const DRAWN: Readonly<Record<ShapeName, () => unknown>> = { sphere, torus, knot, vase, creature };

export function shapeIcon(shape: ShapeName): TemplateResult {
  return html`<svg viewBox="0 0 48 48" aria-hidden="true">${DRAWN[shape]()}</svg>`;
}
