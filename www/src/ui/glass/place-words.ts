/** What there is to say of a place on a wire. */

import { msg, str } from "@lit/localize";
import type { View } from "../../engine/protocol";
import { count, decimal, percent } from "../../words/numbers";
import { radiusInDiameters, type Profile } from "../../view/profile";

/** Bends wider than that, radius in diameters, are as good as straight. */
const STRAIGHT = 100;
/** Of the pictures that settings speak of. */
const PICTURE_PX = 256;
/** A sculpture of that size is what hands bend. */
const ACROSS_MM = 200;

/** World units in a pixel of a picture of 256; null where no view has one scale. */
function pixelOf(views: readonly View[]): number | null {
  const heights = views.flatMap(({ height_world }) => height_world ?? []);
  return heights.length ? heights.reduce((sum, height) => sum + height, 0) / heights.length / PICTURE_PX : null;
}

/** Millimetres in a world unit where the wire's largest side is 20 cm. */
function millimetre({ places, count: samples }: Profile): number {
  let largest = 0;
  for (let c = 0; c < 3; c++) {
    let [low, high] = [Infinity, -Infinity];
    for (let i = 0; i < samples; i++) [low, high] = [Math.min(low, places[3 * i + c]!), Math.max(high, places[3 * i + c]!)];
    largest = Math.max(largest, high - low);
  }
  return largest > 0 ? ACROSS_MM / largest : 0;
}

/** Where it is, how it bends there and how thick it is: in diameters, in pixels of the pictures, and in a sculpture of 20 cm. */
export function placeWords(profile: Profile, at: number, views: readonly View[]): string {
  const diameters = radiusInDiameters(profile, at);
  const width = profile.widths[at]!;
  const [px, mm] = [pixelOf(views), millimetre(profile)];
  const sizes = (world: number): string => [px ? msg(str`${figure(world / px)} px`) : "", msg(str`${figure(world * mm)} mm`)].filter(Boolean).join(", ");
  const where = msg(str`${percent(profile.shares[at]!)} along`);
  const thick = msg(str`${sizes(width)} thick`);
  if (diameters > STRAIGHT) return [where, msg("straight"), thick].join(" · ");
  return [where, msg(str`bend radius ${figure(diameters)} diameters (${sizes(1 / profile.curvatures[at]!)})`), thick].join(" · ");
}

/** Two digits that count. */
const figure = (value: number): string => (value < 0.05 ? "0" : value >= 10 ? count(Math.round(value)) : decimal(value, 1));
