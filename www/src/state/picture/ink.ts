/**
 * What drawings and masks come down to: ink laid onto a sheet, in plain arithmetic, the same in every browser.
 *
 * Pixel (x, y) covers [x, x + 1] × [y, y + 1], y down; ink is 0 (ground) to 255.
 */

type Sheet = Uint8Array<ArrayBuffer>;

/** Mirrored left to right first, then turned counter-clockwise by quarters. */
export interface Lay {
  readonly mirrored: boolean;
  readonly quarterTurns: number;
}

/** A line of a round pen, or of an eraser. */
export interface PenLine {
  readonly erase: boolean;
  readonly widthPx: number;
  /** x, y, x, y, … in px of the sheet. */
  readonly points: Float32Array<ArrayBuffer>;
}

/** More ink wins: drawings never darken where they cross. */
export function over(sheet: Sheet, ink: Sheet): void {
  for (let i = 0; i < sheet.length; i++) if (ink[i]! > sheet[i]!) sheet[i] = ink[i]!;
}

/** A round pen along a polyline. A pixel is covered by how far the pen's rim lies beyond its centre, up to one pixel. */
export function stroke(sheet: Sheet, width: number, { points, widthPx, erase }: PenLine): void {
  const count = points.length / 2;
  for (let i = 0; i < count; i++) {
    const next = Math.min(i + 1, count - 1);
    if (i === next && count > 1) break;
    segment(sheet, width, points[2 * i]!, points[2 * i + 1]!, points[2 * next]!, points[2 * next + 1]!, widthPx / 2, erase);
  }
}

function segment(sheet: Sheet, width: number, ax: number, ay: number, bx: number, by: number, radius: number, erase: boolean): void {
  const [dx, dy] = [bx - ax, by - ay];
  const perLength2 = dx || dy ? 1 / (dx * dx + dy * dy) : 0;
  const reach = radius + 0.5;
  const solid2 = Math.max(0, radius - 0.5) ** 2;
  const [left, right] = span(ax, bx, reach, width);
  const [top, bottom] = span(ay, by, reach, sheet.length / width);
  for (let y = top; y < bottom; y++) {
    const py = y + 0.5 - ay;
    for (let x = left; x < right; x++) {
      const px = x + 0.5 - ax;
      const t = Math.min(1, Math.max(0, (px * dx + py * dy) * perLength2));
      const [ex, ey] = [px - t * dx, py - t * dy];
      const distance2 = ex * ex + ey * ey;
      if (distance2 >= reach * reach) continue;
      const covered = distance2 <= solid2 ? 255 : Math.min(255, Math.round(255 * (reach - Math.sqrt(distance2))));
      const i = y * width + x;
      sheet[i] = erase ? Math.min(sheet[i]!, 255 - covered) : Math.max(sheet[i]!, covered);
    }
  }
}

const span = (a: number, b: number, reach: number, side: number): readonly [number, number] => [
  Math.max(0, Math.floor(Math.min(a, b) - reach)),
  Math.min(side, Math.ceil(Math.max(a, b) + reach)),
];

/** The same line with fewer points: none is further than the tolerance from what is left (Douglas and Peucker's way). */
export function thinned(points: Float32Array<ArrayBuffer>, tolerance: number): Float32Array<ArrayBuffer> {
  const count = points.length / 2;
  if (count < 3) return points;
  const kept = new Set([0, count - 1]);
  const open: [number, number][] = [[0, count - 1]];
  for (let range = open.pop(); range; range = open.pop()) {
    const [first, last] = range;
    let [furthest, most] = [0, tolerance];
    for (let i = first + 1; i < last; i++) {
      const distance = offLine(points, i, first, last);
      if (distance > most) [furthest, most] = [i, distance];
    }
    if (furthest === 0) continue;
    kept.add(furthest);
    open.push([first, furthest], [furthest, last]);
  }
  return Float32Array.from([...kept].sort((a, b) => a - b).flatMap((i) => [points[2 * i]!, points[2 * i + 1]!]));
}

/** How far a point is from the segment between two others. */
function offLine(points: Float32Array, i: number, a: number, b: number): number {
  const [ax, ay] = [points[2 * a]!, points[2 * a + 1]!];
  const [dx, dy] = [points[2 * b]! - ax, points[2 * b + 1]! - ay];
  const [px, py] = [points[2 * i]! - ax, points[2 * i + 1]! - ay];
  const t = dx || dy ? Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy))) : 0;
  return Math.hypot(px - t * dx, py - t * dy);
}

/** The sheet mirrored and turned; exact. */
export function laid(sheet: Sheet, side: number, { mirrored, quarterTurns }: Lay): Sheet {
  const turns = quarters(quarterTurns);
  if (!mirrored && turns === 0) return sheet;
  const result = new Uint8Array(sheet.length);
  const last = side - 1;
  for (let y = 0; y < side; y++) {
    for (let x = 0; x < side; x++) {
      let [u, v] = [mirrored ? last - x : x, y];
      for (let turn = 0; turn < turns; turn++) [u, v] = [v, last - u];
      result[v * side + u] = sheet[y * side + x]!;
    }
  }
  return result;
}

/** A stroke's points mirrored and turned; exact for points on a binary grid. */
export function laidPoints(points: Float32Array<ArrayBuffer>, side: number, { mirrored, quarterTurns }: Lay): Float32Array<ArrayBuffer> {
  const result = points.slice();
  for (let i = 0; i < points.length; i += 2) {
    let [u, v] = [mirrored ? side - points[i]! : points[i]!, points[i + 1]!];
    for (let turn = 0; turn < quarters(quarterTurns); turn++) [u, v] = [v, side - u];
    result[i] = u;
    result[i + 1] = v;
  }
  return result;
}

/** 0 to 3, whichever way and however often. */
export const quarters = (turns: number): number => ((turns % 4) + 4) % 4;
