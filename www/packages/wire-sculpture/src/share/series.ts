/** The order in which control points are read, and what each is guessed from. Twin of `src/export/share/series.rs`. */

import { clamp, Series } from "./guess";
import { Nonsense, type RangeDecoder } from "./range";

const POINT_WEIGHTS = [0.95, -0.15, 0.05, 0];
const WIDTH_WEIGHTS = [0.7, 0, 0, 0];
const FOLLOWING_WEIGHTS = [1, -0.5, 0, 0];

const COORDINATES = [0, 1, 2] as const;
const WIDTHS = [3] as const;

/** x, y, z, width for each control point, in steps. */
type Points = Int32Array;

/** Control points one after another, then their widths: each from the last four differences. */
export function readPoints(coder: RangeDecoder, points: Points): void {
  const along = (column: number, at: number, inputs: Float64Array): number => {
    for (let k = 0; k < 4; k++) inputs[k] = step(points, at - k - 1, column);
    return column < 3 ? inputs[0]! : 0;
  };
  readColumns(coder, points, COORDINATES, new Series(3, POINT_WEIGHTS), along);
  readColumns(coder, points, WIDTHS, new Series(1, WIDTH_WEIGHTS), along);
}

/** What is learned of wires that follow each other. */
export class Following {
  private readonly points = new Series(3, FOLLOWING_WEIGHTS);
  private readonly widths = new Series(1, FOLLOWING_WEIGHTS);

  /** Control points that are guessed from as many `before`: from where they were, and where their neighbour has gone since. */
  read(coder: RangeDecoder, points: Points, before: Points): void {
    const after = (column: number, at: number, inputs: Float64Array): number => {
      const here = 4 * at + column;
      const last = points[here - 4] ?? 0;
      inputs[0] = step(before, at, column);
      inputs[1] = at > 0 ? last - before[here - 4]! : 0;
      inputs[2] = step(points, at - 1, column);
      inputs[3] = step(points, at - 2, column);
      return before[here]! - last;
    };
    readColumns(coder, points, COORDINATES, this.points, after);
    readColumns(coder, points, WIDTHS, this.widths, after);
  }
}

/** A step of a column; there was none before the first point, which is as far from zero. */
function step(points: Points, at: number, column: number): number {
  if (at < 0) return 0;
  return points[4 * at + column]! - (points[4 * at + column - 4] ?? 0);
}

/** `guess` gives a first guess of the next step, and the inputs of a better one. */
function readColumns(
  coder: RangeDecoder,
  points: Points,
  columns: readonly number[],
  series: Series,
  guess: (column: number, at: number, inputs: Float64Array) => number,
): void {
  const inputs = columns.map(() => new Float64Array(4));
  const plain = columns.map(() => 0);
  for (let at = 0; 4 * at < points.length; at++) {
    columns.forEach((column, k) => (plain[k] = guess(column, at, inputs[k]!)));
    const ahead = series.next(coder, plain, inputs);
    columns.forEach((column, k) => {
      const here = 4 * at + column;
      points[here] = clamp((points[here - 4] ?? 0) + ahead[k]!);
    });
    if (coder.exhausted) throw new Nonsense();
  }
}
