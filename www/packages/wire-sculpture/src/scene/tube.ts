/** Samples turned into rings: a frame that does not twist along the wire, and round caps at its ends. */

import { RINGS_A_ROW } from "./shaders";
import type { Samples } from "./shape";

/** Floats for each ring: centre 3, radius, tangent 3, tone, normal 3, lean. See `shaders.ts`. */
export const RING_FLOATS = 12;
const CAP_RINGS = 5;

/**
 * Rings in drawing order, each joined to the next. Every strip begins and ends in a pole of radius 0, so what joins
 * two strips has no area.
 */
export interface Rings {
  readonly count: number;
  readonly data: Float32Array<ArrayBuffer>;
}

/**
 * Rings for every strip. The tone of each sample, 0 to 1, says where on the colour map it is. The lean of the surface
 * along the wire is the sine of its angle: ±1 at the poles, minus the growth of the radius elsewhere. `data` is `reuse`
 * where that is large enough.
 */
export function buildRings(samples: Samples, tones: ArrayLike<number>, reuse?: Float32Array<ArrayBuffer>): Rings {
  const { points } = samples;
  const count = samples.strips.reduce((sum, s) => sum + s.last - s.first + 1 + (s.closed ? 1 : 2 * CAP_RINGS), 0);
  // With room for what comes next, and for a last row of the texture that holds them.
  const length = (count + RINGS_A_ROW) * RING_FLOATS;
  const data = reuse && reuse.length >= length ? reuse : new Float32Array(2 * length);
  const frame = new Frame();
  let at = 0;

  /** A ring in the frame's plane, `shift` along its tangent from sample `k`. */
  const put = (k: number, radius: number, shift: number, lean: number): void => {
    data[at] = points[4 * k]! + frame.tx * shift;
    data[at + 1] = points[4 * k + 1]! + frame.ty * shift;
    data[at + 2] = points[4 * k + 2]! + frame.tz * shift;
    data[at + 3] = radius;
    data[at + 4] = frame.tx;
    data[at + 5] = frame.ty;
    data[at + 6] = frame.tz;
    data[at + 7] = tones[k]!;
    data[at + 8] = frame.nx;
    data[at + 9] = frame.ny;
    data[at + 10] = frame.nz;
    data[at + 11] = lean;
    at += RING_FLOATS;
  };
  /** From the pole to the rim at the start of a strip, and back at its end. */
  const cap = (k: number, direction: 1 | -1): void => {
    const radius = points[4 * k + 3]!;
    for (let step = 0; step < CAP_RINGS; step++) {
      const angle = (Math.PI / 2) * (direction < 0 ? 1 - step / CAP_RINGS : (step + 1) / CAP_RINGS);
      const pole = direction < 0 ? step === 0 : step === CAP_RINGS - 1;
      const along = direction * Math.sin(angle);
      put(k, pole ? 0 : Math.cos(angle) * radius, along * radius, pole ? direction : along);
    }
  };
  const taper = (a: number, b: number): number => {
    const dx = points[4 * b]! - points[4 * a]!;
    const dy = points[4 * b + 1]! - points[4 * a + 1]!;
    const dz = points[4 * b + 2]! - points[4 * a + 2]!;
    const run = Math.sqrt(dx * dx + dy * dy + dz * dz);
    return Math.max(-0.9, Math.min(0.9, (points[4 * a + 3]! - points[4 * b + 3]!) / Math.max(run, 1e-6)));
  };

  for (const { first, last, closed } of samples.strips) {
    frame.restart();
    for (let k = first; k <= last; k++) {
      frame.moveTo(samples, k, Math.max(first, k - 1), Math.min(last, k + 1));
      if (k === first && !closed) cap(k, -1);
      const before = k > first ? k - 1 : closed ? last : k;
      const after = k < last ? k + 1 : closed ? first : k;
      put(k, points[4 * k + 3]!, 0, taper(before, after));
    }
    if (!closed) {
      cap(last, 1);
    } else {
      // A closed strip ends with the last frame, not the first: both lie on the same circle, and this one does not twist.
      frame.moveTo(samples, first, last, first + 1);
      put(first, points[4 * first + 3]!, 0, taper(last, first + 1));
      data[at - RING_FLOATS + 7] = tones[last]!;
    }
  }
  return { count: at / RING_FLOATS, data };
}

/** A tangent and a normal carried along a strip. */
class Frame {
  tx = 1;
  ty = 0;
  tz = 0;
  nx = 0;
  ny = 0;
  nz = 0;

  restart(): void {
    [this.tx, this.ty, this.tz] = [1, 0, 0];
    this.nx = this.ny = this.nz = 0;
  }

  /** To sample `k`; where the curve stands still its direction is that from `before` to `after`, and failing that kept. */
  moveTo({ points, tangents }: Samples, k: number, before: number, after: number): void {
    if (!this.point(tangents[3 * k]!, tangents[3 * k + 1]!, tangents[3 * k + 2]!)) {
      const [a, b] = [4 * before, 4 * after];
      this.point(points[b]! - points[a]!, points[b + 1]! - points[a + 1]!, points[b + 2]! - points[a + 2]!);
    }
    // The normal before made perpendicular again: on a fine curve that turns with it and does not twist.
    if (this.straighten(this.nx, this.ny, this.nz)) return;
    // Any axis that is far from the tangent.
    if (Math.abs(this.tx) < 0.6) this.straighten(1, 0, 0);
    else this.straighten(0, 1, 0);
  }

  private point(x: number, y: number, z: number): boolean {
    const norm = Math.sqrt(x * x + y * y + z * z);
    if (!(norm > 1e-9)) return false;
    this.tx = x / norm;
    this.ty = y / norm;
    this.tz = z / norm;
    return true;
  }

  private straighten(x: number, y: number, z: number): boolean {
    const along = x * this.tx + y * this.ty + z * this.tz;
    const px = x - along * this.tx;
    const py = y - along * this.ty;
    const pz = z - along * this.tz;
    const norm = Math.sqrt(px * px + py * py + pz * pz);
    if (!(norm > 0.05)) return false;
    this.nx = px / norm;
    this.ny = py / norm;
    this.nz = pz / norm;
    return true;
  }
}
