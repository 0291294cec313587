/** Where the lines of a short text break, and how its letters fill a square best. Knows no fonts: it is told what text measures. */

/** Ink of a line written at some size: distances from its middle (along) and its baseline (across). */
export interface Extent {
  readonly left: number;
  readonly right: number;
  readonly ascent: number;
  readonly descent: number;
}

export interface Block {
  readonly lines: readonly { readonly text: string; readonly baseline: number }[];
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Between the ink of two lines, as a share of the tallest line's ink. */
const LEADING = 0.22;
/** Another line has to make the letters this much larger. */
const WORTH = 1.1;

/** What must not be broken: words, and single letters of scripts that are written without spaces. */
interface Piece {
  readonly text: string;
  readonly spaced: boolean;
}

const UNSPACED = /^[\p{Script=Han}\p{Script=Hiragana}\p{Script=Katakana}\p{Extended_Pictographic}]/u;

/** What a person sees as single letters and signs. */
export function graphemes(text: string): readonly string[] {
  return [...new Intl.Segmenter(undefined, { granularity: "grapheme" }).segment(text)].map(({ segment }) => segment);
}

function piecesOf(text: string): readonly Piece[] {
  const pieces: Piece[] = [];
  for (const word of text.trim().split(/\s+/u)) {
    let spaced = pieces.length > 0;
    let open = false;
    for (const letter of graphemes(word)) {
      const alone = UNSPACED.test(letter);
      const last = pieces.at(-1);
      if (open && !alone && last) pieces[pieces.length - 1] = { ...last, text: last.text + letter };
      else pieces.push({ text: letter, spaced });
      open = !alone;
      spaced = false;
    }
  }
  return pieces;
}

/** The lines that let the text stand largest in a square. */
export function layOut(text: string, measure: (line: string) => Extent): Block {
  const pieces = piecesOf(text);
  const widths = pieces.map((piece) => width(measure(piece.text)));
  const space = width(measure("n n")) - width(measure("nn"));
  let best = blockOf([joined(pieces)], measure);
  for (let count = 2; count <= pieces.length; count++) {
    const lines = broken(pieces, widths, space, count);
    if (lines.length < count) continue;
    const block = blockOf(lines, measure);
    if (size(block) > WORTH * size(best)) best = block;
    // The letters only get smaller once the lines fill the square's height.
    if (block.height > 1.5 * block.width) break;
  }
  return best;
}

const width = ({ left, right }: Extent): number => left + right;
const size = (block: Block): number => 1 / Math.max(block.width, block.height);
const joined = (pieces: readonly Piece[]): string => pieces.map(({ text, spaced }, i) => (spaced && i > 0 ? ` ${text}` : text)).join("");

/** At most that many lines, the longest as short as can be: bisects how long a line may get. */
function broken(pieces: readonly Piece[], widths: readonly number[], space: number, count: number): readonly string[] {
  let [low, high] = [Math.max(...widths), widths.reduce((sum, value) => sum + value + space, 0)];
  let lines = filled(pieces, widths, space, high);
  for (let i = 0; i < 16; i++) {
    const middle = (low + high) / 2;
    const tried = filled(pieces, widths, space, middle);
    if (tried.length <= count) [high, lines] = [middle, tried];
    else low = middle;
  }
  return lines.map(joined);
}

function filled(pieces: readonly Piece[], widths: readonly number[], space: number, room: number): readonly (readonly Piece[])[] {
  const lines: Piece[][] = [];
  let used = Infinity;
  for (const [i, piece] of pieces.entries()) {
    const more = widths[i]! + (piece.spaced ? space : 0);
    if (used + more <= room) {
      lines.at(-1)!.push(piece);
      used += more;
    } else {
      lines.push([piece]);
      used = widths[i]!;
    }
  }
  return lines;
}

function blockOf(texts: readonly string[], measure: (line: string) => Extent): Block {
  const extents = texts.map(measure);
  const gap = LEADING * Math.max(...extents.map(({ ascent, descent }) => ascent + descent));
  let baseline = 0;
  const lines = texts.map((text, i) => {
    if (i > 0) baseline += extents[i - 1]!.descent + gap + extents[i]!.ascent;
    return { text, baseline };
  });
  const left = Math.min(...extents.map((extent) => -extent.left));
  const right = Math.max(...extents.map((extent) => extent.right));
  const top = -extents[0]!.ascent;
  return { lines, left, top, width: right - left, height: baseline + extents.at(-1)!.descent - top };
}
