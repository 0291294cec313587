/** What a film shows when: how far the camera has turned, and which wire there is. */

/** One moment of a film. */
export interface Moment {
  /** Round the upright axis, from where the film begins to look; radians. */
  readonly turnRad: number;
  /** Place in the way of the wire: 0 is the first that was found, 1 the finished one. */
  readonly way: number;
}

export interface Film {
  readonly seconds: number;
  /** Whether it goes on where it began: its last frame is then one step before its first. */
  readonly loops: boolean;
  /** How far the camera ever is from its middle; radians, at most half a turn. */
  readonly swingRad: number;
  /** What there is at a share of it, 0 to 1. */
  at(share: number): Moment;
}

/** Slow at both ends, and still there: the minimum-jerk curve. */
export const eased = (share: number): number => {
  const k = Math.max(0, Math.min(1, share));
  return k * k * k * (k * (6 * k - 15) + 10);
};

/** Once round, at an even pace. */
export const TURNTABLE: Film = {
  seconds: 6,
  loops: true,
  swingRad: Math.PI,
  at: (share) => ({ turnRad: 2 * Math.PI * share, way: 1 }),
};

/** Of the film about how a wire was found, seconds: the way itself, a look at where it led, and a turn to either side. */
const WAY_S = 4.4;
const LOOK_S = 0.4;
const TURN_S = 3;
const REST_S = 0.2;
/** How far the camera comes from while the wire is found, and how far the turn goes; radians. */
const DRIFT_RAD = 0.3;
const TURN_RAD = 0.55;

/** From the first wire to the last, whose shadows are the pictures by then; and a short turn, to see that it is one wire. */
export const FOUND: Film = {
  seconds: WAY_S + LOOK_S + TURN_S + REST_S,
  loops: false,
  swingRad: TURN_RAD,
  at(share) {
    const second = share * this.seconds;
    const way = eased(second / WAY_S);
    const turn = eased((second - WAY_S - LOOK_S) / TURN_S);
    return { turnRad: TURN_RAD * Math.sin(2 * Math.PI * turn) - DRIFT_RAD * (1 - way), way };
  },
};

/** The moments of a film of so many frames. */
export function momentsOf(film: Film, frames: number): Moment[] {
  const steps = Math.max(1, film.loops ? frames : frames - 1);
  return Array.from({ length: frames }, (_, i) => film.at(i / steps));
}
