/** A view as in wire.json: a picture taken from somewhere. */
export interface View {
  readonly name: string;
  readonly projection: "orthographic" | "perspective";
  readonly eye: readonly [number, number, number];
  readonly target: readonly [number, number, number];
  readonly up: readonly [number, number, number];
  readonly fov_y_rad?: number;
  readonly height_world?: number;
  readonly width_px: number;
  readonly height_px: number;
}
