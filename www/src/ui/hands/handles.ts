/** Control points over the stage, and the polygon between those of a stretch. */

import type { Mat4 } from "#sculpture/scene/matrix";
import { onPicture } from "../../view/on-picture";

export interface Handles {
  /** x, y, z and width of each. */
  readonly points: ArrayLike<number>;
  readonly held: number;
  /** The other end of the stretch. */
  readonly end: number;
  readonly ink: string;
  readonly halo: string;
}

const DOT_PX = 2.5;
const HELD_PX = 7;

export function paintHandles(canvas: HTMLCanvasElement, clip: Mat4 | null, { points, held, end, ink, halo }: Handles): void {
  const { clientWidth: width, clientHeight: height } = canvas;
  const density = Math.min(2, devicePixelRatio);
  [canvas.width, canvas.height] = [width * density, height * density];
  const context = canvas.getContext("2d")!;
  if (!clip) return;
  context.scale(density, density);
  const seen = (i: number): readonly [number, number] | null => onPicture(clip, width, height, points[4 * i]!, points[4 * i + 1]!, points[4 * i + 2]!);
  const dot = (i: number, radius: number, isRing = false): void => {
    const place = seen(i);
    if (!place) return;
    context.beginPath();
    context.arc(place[0], place[1], radius, 0, 2 * Math.PI);
    context.strokeStyle = halo;
    context.lineWidth = isRing ? 5 : 2;
    context.stroke();
    if (isRing) {
      context.strokeStyle = ink;
      context.lineWidth = 2;
      context.stroke();
    } else {
      context.fillStyle = ink;
      context.fill();
    }
  };
  const [first, last] = [Math.min(held, end), Math.max(held, end)];
  context.beginPath();
  for (let i = first; i <= last; i++) {
    const place = seen(i);
    if (place) context.lineTo(place[0], place[1]);
  }
  context.setLineDash([4, 4]);
  for (const [style, thick] of [[halo, 3], [ink, 1]] as const) {
    [context.strokeStyle, context.lineWidth] = [style, thick];
    context.stroke();
  }
  context.setLineDash([]);
  for (let i = 0; i < points.length / 4; i++) dot(i, DOT_PX);
  dot(end, HELD_PX - 2, true);
  dot(held, HELD_PX, true);
}
