/** The camera: a direction, a distance and a point to look at, eased from where it is to where it should be. */

import { add, perspective, scale, type Mat4, type Vec3 } from "./matrix";

export interface Pose {
  /** 0 is the front (camera on +z), a quarter turn the side (camera on +x). */
  azimuthRad: number;
  /** A quarter turn is the top. */
  elevationRad: number;
  /** World units from the middle of the picture to its nearer border. */
  reach: number;
  /** Near zero when a view is looked at straight on, so that the drawing fits its shadow. */
  fovYRad: number;
  target: Vec3;
}

const QUARTER = Math.PI / 2;
const NARROW_RAD = 0.02;

export const HOME: Readonly<Pose> = { azimuthRad: 0.68, elevationRad: 0.42, reach: 1.48, fovYRad: 0.5, target: [-0.16, -0.2, -0.16] };
export const VIEW_POSES: Readonly<Record<"front" | "side" | "top", Pose>> = {
  front: { azimuthRad: 0, elevationRad: 0, reach: 0.95, fovYRad: NARROW_RAD, target: [0, 0, 0] },
  side: { azimuthRad: QUARTER, elevationRad: 0, reach: 0.95, fovYRad: NARROW_RAD, target: [0, 0, 0] },
  top: { azimuthRad: 0, elevationRad: QUARTER, reach: 0.95, fovYRad: NARROW_RAD, target: [0, 0, 0] },
};

export interface Camera {
  clipFromWorld: Mat4;
  eye: Vec3;
  /** World units a pixel covers at distance 1. */
  worldPerPixel: number;
}

export class Orbit {
  pose: Pose = { ...HOME };
  private flight: { from: Pose; to: Pose; startMs: number; durationMs: number } | null = null;

  /** Eases to a pose; `durationMs` 0 jumps. */
  flyTo(to: Pose, nowMs: number, durationMs: number): void {
    const from = { ...this.pose };
    // The short way round.
    from.azimuthRad = to.azimuthRad + wrapped(from.azimuthRad - to.azimuthRad);
    this.flight = { from, to: { ...to }, startMs: nowMs, durationMs };
    this.advance(nowMs);
  }

  /** A person took hold: whatever flight there was ends here. */
  turn(azimuthRad: number, elevationRad: number): void {
    this.take();
    this.pose.azimuthRad += azimuthRad;
    this.pose.elevationRad = Math.max(-1.45, Math.min(QUARTER, this.pose.elevationRad + elevationRad));
  }

  zoom(factor: number): void {
    this.take();
    this.pose.reach = Math.max(0.15, Math.min(4, this.pose.reach * factor));
  }

  /** By shares of the picture's half height. */
  pan(right: number, up: number): void {
    this.take();
    const axes = axesOf(this.pose);
    const moved = add(add(this.pose.target, scale(axes.right, right * this.pose.reach)), scale(axes.up, up * this.pose.reach));
    this.pose.target = moved.map((x) => Math.max(-1.5, Math.min(1.5, x))) as unknown as Vec3;
  }

  /** Moves along the flight; whether there still is one. */
  advance(nowMs: number): boolean {
    const flight = this.flight;
    if (!flight) return false;
    const share = flight.durationMs > 0 ? Math.min(1, (nowMs - flight.startMs) / flight.durationMs) : 1;
    const k = share * share * (3 - 2 * share);
    const mix = (a: number, b: number): number => a + (b - a) * k;
    const { from, to } = flight;
    this.pose = {
      azimuthRad: mix(from.azimuthRad, to.azimuthRad),
      elevationRad: mix(from.elevationRad, to.elevationRad),
      reach: mix(from.reach, to.reach),
      fovYRad: from.fovYRad * (to.fovYRad / from.fovYRad) ** k,
      target: [0, 1, 2].map((c) => mix(from.target[c]!, to.target[c]!)) as unknown as Vec3,
    };
    if (share >= 1) this.flight = null;
    return this.flight !== null;
  }

  get flying(): boolean {
    return this.flight !== null;
  }

  camera(widthPx: number, heightPx: number): Camera {
    const { pose } = this;
    const { right, up, back } = axesOf(pose);
    const aspect = widthPx / heightPx;
    // The nearer border decides: on a tall narrow picture that is the sides.
    const halfHeight = aspect < 1 ? pose.reach / aspect : pose.reach;
    const distance = halfHeight / Math.tan(pose.fovYRad / 2);
    const eye = add(pose.target, scale(back, distance));
    const near = Math.max(0.05, distance - 6);
    return {
      clipFromWorld: perspective(right, up, back, eye, pose.fovYRad, aspect, near, distance + 6),
      eye,
      worldPerPixel: (2 * Math.tan(pose.fovYRad / 2)) / heightPx,
    };
  }

  private take(): void {
    this.flight = null;
    // Out of a straight view the usual lens comes back, or turning would feel flat.
    if (this.pose.fovYRad < HOME.fovYRad) this.pose.fovYRad = HOME.fovYRad;
  }
}

/** Axes of the direction; up is its derivative by elevation, so that the top view has -z up. */
export function axesOf(pose: Pick<Pose, "azimuthRad" | "elevationRad">): { right: Vec3; up: Vec3; back: Vec3 } {
  const [sinA, cosA] = [Math.sin(pose.azimuthRad), Math.cos(pose.azimuthRad)];
  const [sinE, cosE] = [Math.sin(pose.elevationRad), Math.cos(pose.elevationRad)];
  return { right: [cosA, 0, -sinA], up: [-sinA * sinE, cosE, -cosA * sinE], back: [sinA * cosE, sinE, cosA * cosE] };
}

function wrapped(angleRad: number): number {
  return angleRad - 2 * Math.PI * Math.round(angleRad / (2 * Math.PI));
}
