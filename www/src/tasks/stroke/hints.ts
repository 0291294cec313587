/**
 * Where a person points: the newest word counts. A mark rubs out those of the other kind under it, and a box holds the marks
 * on the object, so that hints never contradict each other.
 */

import { maskSize, maskStroke, type Box, type MaskStroke, type Subject } from "./given";

export type Hints = Required<Pick<Subject, "box" | "marks">>;

/** Between two places at which an older mark is looked at, share of the picture's longer side. */
const STEP = 1 / 256;

export function hintsWithMark(subject: Subject, mark: MaskStroke): Hints {
  const { box = null, marks = [], picture } = subject;
  const longer = Math.max(picture.width, picture.height);
  const [across, down] = [picture.width / longer, picture.height / longer];
  const kept = marks.flatMap((known) => {
    if (known.adds === mark.adds) return [known];
    const reach = 0.5 * (known.width + mark.width);
    return without(subject, known, (x, y) => distance(mark.points, x, y, across, down) < reach);
  });
  return { box: box && mark.adds ? boxRound(box, mark.points) : box, marks: [...kept, mark] };
}

export function hintsWithBox(subject: Subject, box: Box | null): Hints {
  const { marks = [] } = subject;
  if (!box) return { box, marks };
  const [left, top, right, bottom] = box;
  const isOutside = (x: number, y: number): boolean => x < left || x > right || y < top || y > bottom;
  return { box, marks: marks.flatMap((known) => (known.adds ? without(subject, known, isOutside) : [known])) };
}

/** What is left of a mark where some of its places go. */
function without(subject: Subject, mark: MaskStroke, isGone: (x: number, y: number) => boolean): MaskStroke[] {
  const size = maskSize(subject);
  const runs: number[][] = [[]];
  let whole = true;
  for (const [x, y] of placesAlong(mark.points)) {
    if (!isGone(x, y)) runs[runs.length - 1]!.push(x * size.width, y * size.height);
    else {
      whole = false;
      runs.push([]);
    }
  }
  return whole ? [mark] : runs.filter(({ length }) => length > 0).map((run) => maskStroke(run, size, mark));
}

function* placesAlong(points: readonly number[]): Generator<readonly [x: number, y: number]> {
  yield [points[0]!, points[1]!];
  for (let i = 2; i < points.length; i += 2) {
    const [x, y, nextX, nextY] = [points[i - 2]!, points[i - 1]!, points[i]!, points[i + 1]!];
    const steps = Math.max(1, Math.ceil(Math.hypot(nextX - x, nextY - y) / STEP));
    for (let k = 1; k <= steps; k++) yield [x + (k / steps) * (nextX - x), y + (k / steps) * (nextY - y)];
  }
}

/** From a place to a line, shares of the picture's longer side. */
function distance(points: readonly number[], x: number, y: number, across: number, down: number): number {
  let least = Infinity;
  for (let i = 0; i < points.length; i += 2) {
    const j = Math.min(i + 2, points.length - 2);
    const [dx, dy] = [across * (points[j]! - points[i]!), down * (points[j + 1]! - points[i + 1]!)];
    const [px, py] = [across * (x - points[i]!), down * (y - points[i + 1]!)];
    const t = Math.min(1, Math.max(0, (px * dx + py * dy) / (dx * dx + dy * dy || 1)));
    least = Math.min(least, Math.hypot(px - t * dx, py - t * dy));
  }
  return least;
}

/** The box, made larger where it does not hold a line. */
function boxRound([left, top, right, bottom]: Box, points: readonly number[]): Box {
  const inside = (value: number): number => Math.min(1, Math.max(0, value));
  const [xs, ys] = [points.filter((_, i) => i % 2 === 0).map(inside), points.filter((_, i) => i % 2 === 1).map(inside)];
  return [Math.min(left, ...xs), Math.min(top, ...ys), Math.max(right, ...xs), Math.max(bottom, ...ys)];
}
