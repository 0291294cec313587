/** How the wire and its room can look. */

/** Colours as `#rrggbb`. */
export interface Look {
  /** Metal of one colour, or a colour map along the wire or by its width. */
  readonly colouring: "metal" | "parameter" | "width";
  /** From one end to the other, or from thin to thick; all the same for metal. */
  readonly ramp: readonly [string, string, string, string, string];
  /** Share of light that is mirrored: 1 is polished, 0 is chalk. */
  readonly gloss: number;
  /** Light from above and from below that the wire mirrors. */
  readonly sky: string;
  readonly ground: string;
  /** The walls, where light falls on them, and where the wire takes it away. */
  readonly wall: string;
  readonly lit: string;
  readonly shadow: string;
  /** Off: the wire alone. */
  readonly room: boolean;
}

export const LOOK_NAMES = ["copper", "steel", "parameter", "width"] as const;
export type LookName = (typeof LOOK_NAMES)[number];

type Room = Pick<Look, "sky" | "ground" | "wall" | "lit" | "shadow">;
const LIGHT: Room = { sky: "#efebe4", ground: "#7c6552", wall: "#f6f3ee", lit: "#fffefb", shadow: "#3d342d" };
const DARK: Room = { sky: "#a39c92", ground: "#2c221a", wall: "#302d29", lit: "#5a534a", shadow: "#0b0a09" };

const plain = (colour: string): Look["ramp"] => [colour, colour, colour, colour, colour];
/** The middle of plasma: told apart with any colour vision, its lightness only rises, and no end is lost on a wall. */
const RAMP: Readonly<Record<"light" | "dark", Look["ramp"]>> = {
  light: ["#2a0593", "#7a02a8", "#b92f86", "#e2625d", "#f79c38"],
  dark: ["#5b2fd0", "#9c2fc4", "#d14a93", "#f07c55", "#fcc63a"],
};

export function lookOf(name: LookName, dark: boolean, room: boolean): Look {
  const walls = dark ? DARK : LIGHT;
  switch (name) {
    case "copper":
      return { ...walls, room, colouring: "metal", gloss: 0.8, ramp: plain(dark ? "#d18a50" : "#bf7640") };
    case "steel":
      return { ...walls, room, colouring: "metal", gloss: 0.9, ramp: plain(dark ? "#686c73" : "#3a3d42") };
    case "parameter":
    case "width":
      return { ...walls, room, colouring: name, gloss: 0.25, ramp: RAMP[dark ? "dark" : "light"] };
  }
}

/** Each sample's place on the ramp, 0 to 1. */
export function tonesOf(colouring: Look["colouring"], samples: { readonly points: Float32Array; readonly parameters: Float32Array }): Float32Array {
  const { points, parameters } = samples;
  if (colouring !== "width") return parameters;
  const tones = new Float32Array(parameters.length);
  let [least, most] = [Infinity, 0];
  for (let at = 3; at < points.length; at += 4) {
    least = Math.min(least, points[at]!);
    most = Math.max(most, points[at]!);
  }
  for (let k = 0; k < tones.length; k++) tones[k] = most - least > 1e-6 ? (points[4 * k + 3]! - least) / (most - least) : 0.5;
  return tones;
}
