/** The camera: a direction, a distance and a point to look at, eased from where it is to where it should be. */

import { QUARTER, USUAL_RAD, type Direction } from "./directions";
import { add, dot, perspective, scale, type Mat4, type Vec3 } from "./matrix";

export { DIRECTIONS, directionOf, type Direction, type Heading, type Vantage, type ViewName } from "./directions";

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

/** How fast the usual lens comes back while somebody turns away from a straight view. */
const WIDEN = 1.3;

export interface Camera {
  clipFromWorld: Mat4;
  eye: Vec3;
  /** World units a pixel covers at distance 1. */
  worldPerPixel: number;
}

/** The pose from which all `points` lie in the middle of the picture and fill this share of it. */
export function framed(direction: Direction, points: readonly Vec3[], aspect: number, share: number): Pose {
  const { right, up, back } = axesOf(direction);
  const slope = Math.tan(direction.fovYRad / 2);
  let target: Vec3 = [0, 0, 0];
  let distance = 2 / slope;
  // A few rounds, since near points move more than far ones do.
  for (let round = 0; round < 8; round++) {
    let [left, rightmost, bottom, top] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const point of points) {
      const from = add(point, scale(target, -1));
      const depth = Math.max(0.1 * distance, distance - dot(from, back)) / distance;
      const [x, y] = [dot(from, right) / depth, dot(from, up) / depth];
      [left, rightmost, bottom, top] = [Math.min(left, x), Math.max(rightmost, x), Math.min(bottom, y), Math.max(top, y)];
    }
    target = add(target, add(scale(right, (left + rightmost) / 2), scale(up, (bottom + top) / 2)));
    distance = Math.max((rightmost - left) / aspect, top - bottom, 0.2) / 2 / share / slope;
  }
  return { ...direction, target, reach: distance * slope * Math.min(1, aspect) };
}

export class Orbit {
  pose: Pose;
  private flight: { from: Pose; to: Pose; startMs: number; durationMs: number } | null = null;

  constructor(pose: Pose) {
    this.pose = { ...pose };
  }

  /** Eases to a pose; `durationMs` 0 jumps. */
  flyTo(to: Pose, nowMs: number, durationMs: number): void {
    const from = { ...this.pose };
    // The short way round.
    from.azimuthRad = to.azimuthRad + wrapped(from.azimuthRad - to.azimuthRad);
    this.flight = { from, to: { ...to }, startMs: nowMs, durationMs };
    this.advance(nowMs);
  }

  /** Where a flight ends, or where the camera is. */
  get destination(): Pose {
    return this.flight?.to ?? this.pose;
  }

  /** A person took hold: whatever flight there was ends here. */
  turn(azimuthRad: number, elevationRad: number): void {
    this.flight = null;
    this.pose = turned(this.pose, azimuthRad, elevationRad, WIDEN);
  }

  zoom(factor: number): void {
    this.flight = null;
    this.pose.reach = zoomed(this.pose.reach, factor);
  }

  /** By shares of the picture's half height. */
  pan(right: number, up: number): void {
    this.flight = null;
    const axes = axesOf(this.pose);
    const moved = add(add(this.pose.target, scale(axes.right, right * this.pose.reach)), scale(axes.up, up * this.pose.reach));
    this.pose.target = moved.map((x) => Math.max(-1.5, Math.min(1.5, x))) as unknown as Vec3;
  }

  /** A step by a button, eased, and added to one that is under way. */
  step(azimuthRad: number, zoom: number, nowMs: number, durationMs: number): void {
    const to = azimuthRad === 0 ? { ...this.destination } : turned(this.destination, azimuthRad, 0, Infinity);
    this.flyTo({ ...to, reach: zoomed(to.reach, zoom) }, nowMs, durationMs);
  }

  /** Moves along the flight; whether there still is one. */
  advance(nowMs: number): boolean {
    const flight = this.flight;
    if (!flight) return false;
    const share = flight.durationMs > 0 ? Math.max(0, Math.min(1, (nowMs - flight.startMs) / flight.durationMs)) : 1;
    const k = share * share * share * (share * (6 * share - 15) + 10);
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
}

export function cameraOf(pose: Pose, widthPx: number, heightPx: number): Camera {
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

/** Out of a straight view the usual lens comes back, or turning would feel flat. */
function turned(pose: Pose, azimuthRad: number, elevationRad: number, widen: number): Pose {
  return {
    ...pose,
    azimuthRad: pose.azimuthRad + azimuthRad,
    elevationRad: Math.max(-1.45, Math.min(QUARTER, pose.elevationRad + elevationRad)),
    fovYRad: Math.min(USUAL_RAD, pose.fovYRad * widen),
  };
}

const zoomed = (reach: number, factor: number): number => Math.max(0.15, Math.min(4, reach * factor));

/** Axes of the direction; up is its derivative by elevation, so that the top view has -z up. */
export function axesOf(pose: Pick<Pose, "azimuthRad" | "elevationRad">): { right: Vec3; up: Vec3; back: Vec3 } {
  const [sinA, cosA] = [Math.sin(pose.azimuthRad), Math.cos(pose.azimuthRad)];
  const [sinE, cosE] = [Math.sin(pose.elevationRad), Math.cos(pose.elevationRad)];
  return { right: [cosA, 0, -sinA], up: [-sinA * sinE, cosE, -cosA * sinE], back: [sinA * cosE, sinE, cosA * cosE] };
}

function wrapped(angleRad: number): number {
  return angleRad - 2 * Math.PI * Math.round(angleRad / (2 * Math.PI));
}
