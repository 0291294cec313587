/** Where a wire is looked at from: all that a page needs to know of cameras that a worker has. */

export interface Direction {
  /** 0 is the front (camera on +z), a quarter turn the side (camera on +x). */
  readonly azimuthRad: number;
  /** A quarter turn is the top. */
  readonly elevationRad: number;
  /** Near zero when a view is looked at straight on, so that the drawing fits its shadow. */
  readonly fovYRad: number;
}

export const QUARTER = Math.PI / 2;
const NARROW_RAD = 0.02;
/** The lens for what is not seen straight on. */
export const USUAL_RAD = 0.46;
export const DIRECTIONS = {
  room: { azimuthRad: 0.7, elevationRad: 0.4, fovYRad: USUAL_RAD },
  front: { azimuthRad: 0, elevationRad: 0, fovYRad: NARROW_RAD },
  side: { azimuthRad: QUARTER, elevationRad: 0, fovYRad: NARROW_RAD },
  right: { azimuthRad: QUARTER, elevationRad: 0, fovYRad: NARROW_RAD },
  back: { azimuthRad: 2 * QUARTER, elevationRad: 0, fovYRad: NARROW_RAD },
  left: { azimuthRad: -QUARTER, elevationRad: 0, fovYRad: NARROW_RAD },
  top: { azimuthRad: 0, elevationRad: QUARTER, fovYRad: NARROW_RAD },
} as const satisfies Readonly<Record<string, Direction>>;

/** The room as a whole, or a view straight on. */
export type ViewName = keyof typeof DIRECTIONS;

/** Anywhere else: straight on, or through the usual lens; `away` is a factor of the distance. */
export type Heading = Pick<Direction, "azimuthRad" | "elevationRad"> & { readonly away?: number; readonly wide?: boolean };

export type Vantage = ViewName | Heading;

export function directionOf(vantage: Vantage): Direction {
  if (typeof vantage === "string") return DIRECTIONS[vantage];
  const { azimuthRad, elevationRad, wide } = vantage;
  return { azimuthRad, elevationRad, fovYRad: wide ? USUAL_RAD : NARROW_RAD };
}
