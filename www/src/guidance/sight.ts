/** What an open network says of a whole picture: where its object is, or how near its parts are. */

import { opened } from "./opened";

interface Pixels {
  readonly width: number;
  readonly height: number;
  /** Straight RGBA, rows from the top. */
  readonly rgba: Uint8ClampedArray;
}

/** Values of a picture's places, of the network's size and not of the picture's. */
export interface Seen {
  /** The network's name. */
  readonly by: string;
  readonly width: number;
  readonly height: number;
  readonly values: Float32Array;
}

/** Null where no network of the kind is open; a GuidanceError where it fails. */
export async function seen(kind: "mask-v1" | "depth-v1", picture: Pixels): Promise<Seen | null> {
  const model = opened(kind);
  if (!model?.isFine) return null;
  const [, , height, width] = model.sidecar.contract.inputs[0]!.shape as readonly number[];
  const answers = await model.run({ image: planes(picture, width!, height!) });
  return { by: model.about.name, width: width!, height: height!, values: "mask" in answers ? answers.mask : answers.depth };
}

/** `[3, height, width]`, 0 to 1: means over each place, on white where the picture is transparent. */
export function planes({ width: across, height: down, rgba }: Pixels, width: number, height: number): Float32Array<ArrayBuffer> {
  const out = new Float32Array(3 * width * height);
  const edge = (i: number, from: number, to: number): number => Math.floor((i * from) / to);
  for (let y = 0; y < height; y++) {
    const [top, bottom] = [edge(y, down, height), Math.max(edge(y + 1, down, height), edge(y, down, height) + 1)];
    for (let x = 0; x < width; x++) {
      const [left, right] = [edge(x, across, width), Math.max(edge(x + 1, across, width), edge(x, across, width) + 1)];
      const share = 1 / (255 * (bottom - top) * (right - left));
      for (let v = top; v < bottom; v++) {
        for (let i = 4 * (v * across + left); i < 4 * (v * across + right); i += 4) {
          const alpha = rgba[i + 3]! / 255;
          for (let c = 0; c < 3; c++) out[(c * height + y) * width + x]! += share * (255 + alpha * (rgba[i + c]! - 255));
        }
      }
    }
  }
  return out;
}

/** Bytes of values between 0 and 1; others are the nearest of these. */
export function bytes(values: Float32Array): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(values, (value) => Math.round(255 * Math.min(1, Math.max(0, value))));
}

/** Depths, of any scale, as a picture of `width` x `height`, the nearest white. */
export function depthPicture(seen: Seen, width: number, height: number): Uint8ClampedArray<ArrayBuffer> {
  let [least, most] = [Infinity, -Infinity];
  for (const value of seen.values) [least, most] = [Math.min(least, value), Math.max(most, value)];
  const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
  const scale = most > least ? 255 / (most - least) : 0;
  const at = (x: number, y: number): number => seen.values[y * seen.width + x]! - least;
  for (let v = 0; v < height; v++) {
    const y = Math.min(seen.height - 1, Math.max(0, ((v + 0.5) * seen.height) / height - 0.5));
    const [top, down] = [Math.floor(y), y % 1];
    for (let u = 0; u < width; u++) {
      const x = Math.min(seen.width - 1, Math.max(0, ((u + 0.5) * seen.width) / width - 0.5));
      const [left, right] = [Math.floor(x), x % 1];
      const row = (row: number): number => at(left, row) * (1 - right) + (right && at(left + 1, row) * right);
      const value = row(top) * (1 - down) + (down && row(top + 1) * down);
      rgba.fill(scale * value, 4 * (v * width + u), 4 * (v * width + u) + 3);
    }
  }
  return rgba;
}
