/** A link as a QR code. */

import { encode } from "uqr";

/** Bytes that the largest code holds, by its level of error correction: 30, 25, 15 and 7 % of it may be lost. */
const HOLDS = { H: 1273, Q: 1663, M: 2331, L: 2953 } as const;
/** Light modules round a code: readers need four. */
const QUIET = 4;

export const MOST_IN_QR = HOLDS.L;

export interface QrCode {
  /** Modules a side, with the quiet zone. */
  readonly side: number;
  readonly level: keyof typeof HOLDS;
  /** The dark modules as the path of an SVG, a unit a module. */
  readonly path: string;
}

/** At the highest level that fits; null where the text is longer than any code holds. */
export function qrOf(text: string): QrCode | null {
  const bytes = new TextEncoder().encode(text);
  const level = (["H", "Q", "M", "L"] as const).find((level) => bytes.length <= HOLDS[level]);
  if (!level) return null;
  const { data, size } = encode([...bytes], { ecc: level, border: QUIET });
  return { side: size, level, path: data.map(rowPath).join("") };
}

/** A file of its own: dark on light whatever the page's colours are. */
export function qrSvg({ side, path }: QrCode): string {
  const box = `viewBox="0 0 ${side} ${side}" width="${8 * side}" height="${8 * side}" shape-rendering="crispEdges"`;
  return `<svg xmlns="http://www.w3.org/2000/svg" ${box}><path fill="#fff" d="M0 0h${side}v${side}H0z"/><path d="${path}"/></svg>`;
}

/** Runs of dark modules, a rectangle each. */
function rowPath(row: readonly boolean[], y: number): string {
  let path = "";
  for (let x = 0; x < row.length; x++) {
    if (!row[x]) continue;
    const from = x;
    while (row[x + 1]) x++;
    const run = x + 1 - from;
    path += `M${from} ${y}h${run}v1h-${run}z`;
  }
  return path;
}
