/** Friendly words for the core's settings, by name. One that is missing here is shown by its own name. */

import { msg } from "@lit/localize";

export interface SettingWords {
  readonly label: string;
  /** Words for the choices, in the order they are offered. */
  readonly choices?: Readonly<Record<string, string>>;
  /** Least, most and step of a slider; the field beside it takes the whole range. Without it there is only the field. */
  readonly slider?: readonly [min: number, max: number, step: number];
}

export const WORDS: Readonly<Record<string, SettingWords>> = {
  preset: { label: msg("Quality"), choices: { fast: msg("Quick sketch"), best: msg("Best wire"), paper: msg("As in the paper") } },
  bend: { label: msg("Bend the drawings to agree"), choices: { none: msg("Not at all"), little: msg("A little"), free: msg("Freely") } },

  seed: { label: msg("Seed") },
  iterations: { label: msg("Steps"), slider: [50, 3000, 50] },
  size: { label: msg("Picture size"), slider: [64, 512, 32] },
  backend: { label: msg("Where it is computed"), choices: { auto: msg("Best there is"), cpu: msg("Processor"), gpu: msg("Graphics card") } },
  when_hidden: { label: msg("When this tab is hidden"), choices: { go: msg("Keep going"), pause: msg("Pause") } },

  smooth: { label: msg("Keep it smooth"), choices: { on: msg("Yes"), off: msg("No, follow every line") } },
  width: { label: msg("Width"), choices: { varying: msg("Thick and thin"), constant: msg("The same everywhere") } },
  bend_radius: { label: msg("Least bend radius"), slider: [0, 5, 0.25] },
  form: { label: msg("Form"), choices: { wire: msg("One smooth wire"), chain: msg("Curves with corners"), bag: msg("Loose curves") } },
  control_points: { label: msg("Control points"), slider: [0, 2000, 10] },
  spacing: { label: msg("Distance between points"), slider: [1, 12, 0.5] },
  shorter: { label: msg("Shorter wire") },
  min_width: { label: msg("Thinnest"), slider: [0, 8, 0.25] },
  max_width: { label: msg("Thickest"), slider: [1, 40, 0.5] },

  arrange: { label: msg("Arrange the drawings") },
  may_swap: { label: msg("They may change places") },
  may_mirror: { label: msg("They may be mirrored") },
  may_turn: { label: msg("They may be turned"), choices: { none: msg("None"), top: msg("Only the top") } },
  read: { label: msg("What of the picture is drawn"), choices: { auto: msg("Whatever suits it"), ink: msg("Its ink"), lines: msg("The lines of a photo"), tone: msg("Its shades") } },
  lines: { label: msg("Lines of a photo"), slider: [0, 60, 5] },
  ink: { label: msg("Ink is"), choices: { auto: msg("Guessed"), dark: msg("Dark"), light: msg("Light") } },
  min_stroke: { label: msg("Thicken thin lines to"), slider: [0, 12, 0.5] },
  max_stretch: { label: msg("Most stretching"), slider: [1, 2, 0.05] },

  start: { label: msg("First wire"), choices: { circuit: msg("A circuit through the drawings"), tree: msg("Grown through them, there and back"), contour: msg("Along the outline, inwards"), stripes: msg("Parallel lines, joined"), tour: msg("A tour of points"), hull: msg("Inside their volume"), ball: msg("In a ball") } },
  reinit: { label: msg("Reuse points that vanish") },
  refine: { label: msg("Add points where needed") },
  smoothness: { label: msg("Calm"), slider: [0, 5, 0.1] },

  stroke_start: { label: msg("First wire"), choices: { contour: msg("Along the outline, inwards"), points: msg("Through points inside"), ball: msg("In a ball") } },
  shade: { label: msg("Shades in a photo's lines"), choices: { none: msg("None"), accent: msg("As wider lines"), full: msg("All: filled with lines") } },
  shading: { label: msg("The front shows"), choices: { lines: msg("Lines, wide where it is dark"), grey: msg("The picture's greys") } },
  hatching: { label: msg("Lines that fill run"), choices: { auto: msg("As suits the shape"), contours: msg("Along the outline"), slices: msg("Round it, like slices") } },
  hatch: { label: msg("Distance of lines"), slider: [2, 40, 1] },
  outline: { label: msg("Width of outlines"), slider: [0.5, 12, 0.5] },
  tone: { label: msg("Tone by width"), slider: [0, 1, 0.05] },
  edges: { label: msg("Inner edges"), slider: [0, 4, 0.1] },
  saliency: { label: msg("Finer where it catches the eye"), slider: [0, 1, 0.05] },
  gloss: { label: msg("Gloss"), slider: [0, 1, 0.05] },
  creases: { label: msg("Lines at creases"), slider: [0, 1, 0.05] },
  roundness: { label: msg("Roundness"), slider: [0, 2, 0.05] },
  most_depth: { label: msg("Most depth"), slider: [0.05, 2, 0.05] },
  sections: { label: msg("Thin lines round a photo's object"), slider: [0, 1, 0.05] },
  relief: { label: msg("Relief by lightness"), slider: [0, 1, 0.05] },
  side_views: { label: msg("Sides it is checked from"), slider: [0, 12, 1] },
  side_weight: { label: msg("Weight of the sides"), slider: [0, 2, 0.05] },

  curve_spacing: { label: msg("Spacing of the lines"), slider: [0.02, 0.2, 0.005] },
  flow: { label: msg("Lines run"), choices: { smooth: msg("As is smoothest"), along: msg("Up and down"), across: msg("Round it"), style: msg("Along the style") } },
  density: { label: msg("Density"), slider: [0.1, 1, 0.05] },
  style_strength: { label: msg("Style"), slider: [0, 1, 0.05] },
  style_size: { label: msg("Size of the style's picture"), slider: [0.2, 2, 0.05] },
  motif: { label: msg("The picture is laid on"), choices: { box: msg("From six sides"), front: msg("Once, from the front"), off: msg("Not at all, only its texture") } },
  hidden_lines: { label: msg("Lines on the far side") },
  looks: { label: msg("Looked at from"), choices: { sides: msg("Five sides"), sphere: msg("Anywhere") } },
  views_at_once: { label: msg("Views at once"), slider: [1, 8, 1] },
  jitter: { label: msg("Turned by up to"), slider: [0, 45, 1] },
  visibility: { label: msg("How suddenly lines vanish"), slider: [5, 120, 5] },
  visibility_bias: { label: msg("Half seen when so far behind"), slider: [0, 0.2, 0.01] },
  surface_pull: { label: msg("Held to the surface"), slider: [0, 10, 0.25] },

  thin: { label: msg("Spare points within"), slider: [0, 1, 0.05] },
  clearance: { label: msg("Push between strands"), slider: [0, 5, 0.25] },
  tightness: { label: msg("Push against tight bends"), slider: [0, 5, 0.25] },
  position_rate: { label: msg("Rate of positions"), slider: [0.05, 2, 0.05] },
  width_rate: { label: msg("Rate of widths"), slider: [0, 1, 0.01] },
  pyramid: { label: msg("Picture pyramid"), choices: { average: msg("Averages"), gaussian: msg("Gaussian") } },
  level_weight: { label: msg("Weight of coarse levels"), slider: [0, 4, 0.1] },
  coarse_share: { label: msg("Share at half size"), slider: [0, 1, 0.05] },
  samples: { label: msg("Samples"), slider: [1, 16, 1] },
  new_point: { label: msg("New points go"), choices: { lacking: msg("Where ink is lacking"), random: msg("Anywhere"), midpoint: msg("Between neighbours") } },
  grid: { label: msg("Grid of the first wire"), slider: [16, 160, 16] },
};

export const GROUPS: Readonly<Record<string, string>> = { run: msg("Run"), wire: msg("Wire"), views: msg("Views"), stroke: msg("Stroke"), surface: msg("Surface"), fit: msg("Fit"), expert: msg("Expert") };

export function wordsFor(name: string): SettingWords {
  if (Object.hasOwn(WORDS, name)) return WORDS[name]!;
  const spaced = name.replaceAll("_", " ");
  return { label: spaced.charAt(0).toUpperCase() + spaced.slice(1) };
}
