/** A step of bending as a picture: what is new in copper, what is there in grey, what is to come faint. */

import { msg } from "@lit/localize";
import { svg, type TemplateResult } from "lit";
import type { Plan, Step } from "../../workshop/orders";

/** Finer than this share of the picture nobody sees. */
const FINE = 0.002;
const MARGIN = 0.06;

type Place = readonly [x: number, y: number];

/** To the right and down, as one sees it from a side. */
export function seenFrom([x, y, z]: Plan["points"][number], { azimuth_deg, elevation_deg }: Pick<Step, "azimuth_deg" | "elevation_deg">): Place {
  const [a, e] = [(azimuth_deg * Math.PI) / 180, (elevation_deg * Math.PI) / 180];
  const across = Math.cos(a) * x - Math.sin(a) * z;
  const up = -Math.sin(a) * Math.sin(e) * x + Math.cos(e) * y - Math.cos(a) * Math.sin(e) * z;
  return [across, -up];
}

export function stepPicture({ points, steps }: Plan, at: number): TemplateResult {
  const step = steps[at]!;
  const places = points.map((point) => seenFrom(point, step));
  const reach = Math.max(...places.flat().map(Math.abs), 1) * (1 + MARGIN);
  const path = (from: number, to: number): string => line(places.slice(from, to + 1), FINE * reach);
  const [x, y] = places[step.to]!;
  return svg`<svg viewBox="${-reach} ${-reach} ${2 * reach} ${2 * reach}" role="img" aria-label=${msg("The wire after this step")}>
    <g fill="none" stroke-linecap="round" stroke-linejoin="round" stroke-width=${0.016 * reach}>
      <path class="ahead" d=${path(step.to, places.length - 1)} />
      <path class="done" d=${path(0, step.from)} />
      <path class="new" d=${path(step.from, step.to)} stroke-width=${0.026 * reach} />
    </g>
    <circle class="new" cx=${x} cy=${y} r=${0.03 * reach} />
  </svg>`;
}

function line(places: readonly Place[], fine: number): string {
  const kept: Place[] = [];
  for (const [i, place] of places.entries()) {
    const last = kept.at(-1);
    if (!last || i === places.length - 1 || Math.hypot(place[0] - last[0], place[1] - last[1]) >= fine) kept.push(place);
  }
  return kept.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");
}
