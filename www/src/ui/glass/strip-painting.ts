/** How tightly a wire bends and how thick it is along its way, as a strip. */

import { radiusInDiameters, type Profile } from "../../view/profile";

/** Bends as tight as that, radius in diameters, reach the top. */
export const TOP = 1;
/** Of the height: what bends have, and where the middle of the width lies. */
const BENDS = 0.58;
const WIDTH_MIDDLE = 0.82;
const WIDTH_HALF = 0.16;

export interface StripColours {
  readonly bend: string;
  readonly tight: string;
  readonly width: string;
  readonly line: string;
  readonly ink: string;
}

/** `least` is the bend radius, in diameters, below which bends are tight; `at` the sample that is looked at. */
export function paintStrip(canvas: HTMLCanvasElement, profile: Profile, least: number, at: number | null, colours: StripColours): void {
  const density = devicePixelRatio || 1;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) => Math.max(1, Math.round(size * density))) as [number, number];
  if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
  const context = canvas.getContext("2d")!;
  context.clearRect(0, 0, width, height);
  const columns = columnsOf(profile, width);
  const floor = BENDS * height;
  const up = (radius: number): number => floor * (1 - Math.min(1, TOP / radius));
  const widest = columns.reduce((most, { width }) => Math.max(most, width), 0) || 1;
  columns.forEach(({ radius, width }, x) => {
    const top = up(radius);
    context.fillStyle = radius < least ? colours.tight : colours.bend;
    context.fillRect(x, top, 1, floor - top);
    const half = Math.max(0.5, (width / widest) * WIDTH_HALF * height);
    context.fillStyle = colours.width;
    context.fillRect(x, WIDTH_MIDDLE * height - half, 1, 2 * half);
  });
  const straight = (y: number, colour: string, dash: readonly number[]): void => {
    context.strokeStyle = colour;
    context.lineWidth = density;
    context.setLineDash(dash.map((length) => length * density));
    context.beginPath();
    context.moveTo(0, y);
    context.lineTo(width, y);
    context.stroke();
  };
  straight(floor, colours.line, []);
  if (least > TOP) straight(up(least), colours.ink, [3, 4]);
  if (at === null || at >= profile.count) return;
  context.fillStyle = colours.ink;
  context.fillRect(Math.round(profile.shares[at]! * (width - 1)) - density, 0, 2 * density, height);
}

interface Column {
  /** Of the tightest bend there, in diameters. */
  readonly radius: number;
  /** The thickest there, world units. */
  readonly width: number;
}

/** What there is to show in each of so many equal parts of the length. */
export function columnsOf(profile: Profile, count: number): readonly Column[] {
  const columns: { radius: number; width: number }[] = Array.from({ length: count }, () => ({ radius: Infinity, width: -1 }));
  for (let i = 0; i < profile.count; i++) {
    const column = columns[Math.min(count - 1, Math.floor(profile.shares[i]! * count))]!;
    column.radius = Math.min(column.radius, radiusInDiameters(profile, i));
    column.width = Math.max(column.width, profile.widths[i]!);
  }
  // Where there are more columns than samples, the last one goes on.
  columns.forEach((column, x) => {
    if (column.width < 0) Object.assign(column, columns[x - 1] ?? { radius: Infinity, width: 0 });
  });
  return columns;
}
