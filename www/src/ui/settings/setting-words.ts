/** Friendly words for the core's settings, by name. One that is missing here is shown by its own name. */

export interface SettingWords {
  readonly label: string;
  /** Words for the choices, in the order they are offered. */
  readonly choices?: Readonly<Record<string, string>>;
  /** Least, most and step of a slider; the field beside it takes the whole range. Without it there is only the field. */
  readonly slider?: readonly [min: number, max: number, step: number];
}

export const WORDS: Readonly<Record<string, SettingWords>> = {
  preset: { label: "Quality", choices: { fast: "Quick sketch", best: "Best wire", paper: "As in the paper" } },
  bend: { label: "Bend the drawings to agree", choices: { none: "Not at all", little: "A little", free: "Freely" } },

  seed: { label: "Seed" },
  iterations: { label: "Steps", slider: [50, 3000, 50] },
  size: { label: "Picture size", slider: [64, 512, 32] },
  backend: { label: "Where it is computed", choices: { auto: "Best there is", cpu: "Processor", gpu: "Graphics card" } },
  when_hidden: { label: "When this tab is hidden", choices: { go: "Keep going", pause: "Pause" } },

  smooth: { label: "Keep it smooth", choices: { on: "Yes", off: "No, follow every line" } },
  width: { label: "Width", choices: { varying: "Thick and thin", constant: "The same everywhere" } },
  bend_radius: { label: "Least bend radius", slider: [0, 5, 0.25] },
  form: { label: "Form", choices: { wire: "One smooth wire", chain: "Curves with corners", bag: "Loose curves" } },
  control_points: { label: "Control points", slider: [0, 2000, 10] },
  spacing: { label: "Distance between points", slider: [1, 12, 0.5] },
  shorter: { label: "Shorter wire" },
  min_width: { label: "Thinnest", slider: [0, 8, 0.25] },
  max_width: { label: "Thickest", slider: [1, 40, 0.5] },

  arrange: { label: "Arrange the drawings" },
  may_swap: { label: "They may change places" },
  may_mirror: { label: "They may be mirrored" },
  may_turn: { label: "They may be turned", choices: { none: "None", top: "Only the top" } },
  read: { label: "What of the picture is drawn", choices: { auto: "Whatever suits it", ink: "Its ink", lines: "The lines of a photo", tone: "Its shades" } },
  lines: { label: "Lines of a photo", slider: [0, 60, 5] },
  ink: { label: "Ink is", choices: { auto: "Guessed", dark: "Dark", light: "Light" } },
  min_stroke: { label: "Thicken thin lines to", slider: [0, 12, 0.5] },
  max_stretch: { label: "Most stretching", slider: [1, 2, 0.05] },

  start: { label: "First wire", choices: { circuit: "A circuit through the drawings", tree: "Grown through them, there and back", contour: "Along the outline, inwards", stripes: "Parallel lines, joined", tour: "A tour of points", hull: "Inside their volume", ball: "In a ball" } },
  reinit: { label: "Reuse points that vanish" },
  refine: { label: "Add points where needed" },
  smoothness: { label: "Calm", slider: [0, 5, 0.1] },

  stroke_start: { label: "First wire", choices: { contour: "Along the outline, inwards", points: "Through points inside", ball: "In a ball" } },
  shade: { label: "Shades in a photo's lines", choices: { none: "None", accent: "As wider lines", full: "All: filled with lines" } },
  shading: { label: "The front shows", choices: { lines: "Lines, wide where it is dark", grey: "The picture's greys" } },
  hatching: { label: "Lines that fill run", choices: { auto: "As suits the shape", contours: "Along the outline", slices: "Round it, like slices" } },
  hatch: { label: "Distance of lines", slider: [2, 40, 1] },
  outline: { label: "Width of outlines", slider: [0.5, 12, 0.5] },
  tone: { label: "Tone by width", slider: [0, 1, 0.05] },
  edges: { label: "Inner edges", slider: [0, 4, 0.1] },
  saliency: { label: "Finer where it catches the eye", slider: [0, 1, 0.05] },
  gloss: { label: "Gloss", slider: [0, 1, 0.05] },
  creases: { label: "Lines at creases", slider: [0, 1, 0.05] },
  roundness: { label: "Roundness", slider: [0, 2, 0.05] },
  most_depth: { label: "Most depth", slider: [0.05, 2, 0.05] },
  sections: { label: "Thin lines round a photo's object", slider: [0, 1, 0.05] },
  relief: { label: "Relief by lightness", slider: [0, 1, 0.05] },
  side_views: { label: "Sides it is checked from", slider: [0, 12, 1] },
  side_weight: { label: "Weight of the sides", slider: [0, 2, 0.05] },

  curve_spacing: { label: "Spacing of the lines", slider: [0.02, 0.2, 0.005] },
  flow: { label: "Lines run", choices: { smooth: "As is smoothest", along: "Up and down", across: "Round it", style: "Along the style" } },
  density: { label: "Density", slider: [0.1, 1, 0.05] },
  style_strength: { label: "Style", slider: [0, 1, 0.05] },
  style_size: { label: "Size of the style's picture", slider: [0.2, 2, 0.05] },
  motif: { label: "The picture is laid on", choices: { box: "From six sides", front: "Once, from the front", off: "Not at all, only its texture" } },
  hidden_lines: { label: "Lines on the far side" },
  looks: { label: "Looked at from", choices: { sides: "Five sides", sphere: "Anywhere" } },
  views_at_once: { label: "Views at once", slider: [1, 8, 1] },
  jitter: { label: "Turned by up to", slider: [0, 45, 1] },
  visibility: { label: "How suddenly lines vanish", slider: [5, 120, 5] },
  visibility_bias: { label: "Half seen when so far behind", slider: [0, 0.2, 0.01] },
  surface_pull: { label: "Held to the surface", slider: [0, 10, 0.25] },

  thin: { label: "Spare points within", slider: [0, 1, 0.05] },
  clearance: { label: "Push between strands", slider: [0, 5, 0.25] },
  tightness: { label: "Push against tight bends", slider: [0, 5, 0.25] },
  position_rate: { label: "Rate of positions", slider: [0.05, 2, 0.05] },
  width_rate: { label: "Rate of widths", slider: [0, 1, 0.01] },
  pyramid: { label: "Picture pyramid", choices: { average: "Averages", gaussian: "Gaussian" } },
  level_weight: { label: "Weight of coarse levels", slider: [0, 4, 0.1] },
  coarse_share: { label: "Share at half size", slider: [0, 1, 0.05] },
  samples: { label: "Samples", slider: [1, 16, 1] },
  new_point: { label: "New points go", choices: { lacking: "Where ink is lacking", random: "Anywhere", midpoint: "Between neighbours" } },
  grid: { label: "Grid of the first wire", slider: [16, 160, 16] },
};

export const GROUPS: Readonly<Record<string, string>> = { run: "Run", wire: "Wire", views: "Views", stroke: "Stroke", surface: "Surface", fit: "Fit", expert: "Expert" };

export function wordsFor(name: string): SettingWords {
  if (Object.hasOwn(WORDS, name)) return WORDS[name]!;
  const spaced = name.replaceAll("_", " ");
  return { label: spaced.charAt(0).toUpperCase() + spaced.slice(1) };
}
