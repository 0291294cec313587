/** The colours of wire and room. Each is a custom property, `--wire-NAME`; here is what it is where nobody sets it. */

/** In light, and in dark. */
export const TINTS = {
  copper: ["#bf7640", "#d18a50"],
  steel: ["#3a3d42", "#686c73"],
  // The middle of plasma: told apart with any colour vision, its lightness only rises, and no end is lost on a wall.
  "ramp-1": ["#2a0593", "#5b2fd0"],
  "ramp-2": ["#7a02a8", "#9c2fc4"],
  "ramp-3": ["#b92f86", "#d14a93"],
  "ramp-4": ["#e2625d", "#f07c55"],
  "ramp-5": ["#f79c38", "#fcc63a"],
  // Light from above and from below that the wire mirrors.
  sky: ["#efebe4", "#a39c92"],
  ground: ["#7c6552", "#2c221a"],
  // The walls, where light falls on them, and where the wire takes it away.
  wall: ["#f6f3ee", "#302d29"],
  lit: ["#fffefb", "#5a534a"],
  shade: ["#3d342d", "#0b0a09"],
  // Rings round places: told from copper and from steel, on light walls and dark ones.
  mark: ["#d81b60", "#d81b60"],
} as const satisfies Readonly<Record<string, readonly [string, string]>>;

export type Tint = keyof typeof TINTS;
/** As `#rrggbb`. */
export type Tints = Readonly<Record<Tint, string>>;

/** As they are where nobody sets them. */
export const usualTints = (dark: boolean): Tints => Object.fromEntries(Object.entries(TINTS).map(([name, both]) => [name, both[dark ? 1 : 0]])) as Tints;

/** Declarations for a style sheet: `--_NAME`, which the page's `--wire-NAME` goes before. */
export const tintDeclarations = (): string =>
  Object.entries(TINTS)
    .map(([name, [light, dark]]) => `--_${name}: var(--wire-${name}, light-dark(${light}, ${dark}));`)
    .join("\n");

/** The colours as they are at an element, whatever way the page has written them. */
export function tintsAt(element: HTMLElement): Tints {
  return Object.fromEntries(Object.keys(TINTS).map((name) => [name, colourAt(element, `var(--_${name})`)])) as Tints;
}

/** A CSS colour as it is at an element, as `#rrggbb`; what is none is the colour of its text. */
export function colourAt(element: HTMLElement, colour: string): string {
  element.style.color = "";
  element.style.color = colour;
  const context = pixel();
  const computed = getComputedStyle(element).color;
  const plain = /^rgb\((\d+), (\d+), (\d+)\)$/.exec(computed)?.slice(1).map(Number);
  if (plain || !context) return hex(plain ?? [0, 0, 0]);
  context.clearRect(0, 0, 1, 1);
  context.fillStyle = computed;
  context.fillRect(0, 0, 1, 1);
  return hex([...context.getImageData(0, 0, 1, 1).data.subarray(0, 3)]);
}

/** The browser knows how every kind of colour looks. */
let onePixel: CanvasRenderingContext2D | null | undefined;
function pixel(): CanvasRenderingContext2D | null {
  return (onePixel ??= Object.assign(document.createElement("canvas"), { width: 1, height: 1 }).getContext("2d", { willReadFrequently: true }));
}

const hex = (parts: readonly number[]): string => `#${parts.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
