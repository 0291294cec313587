/**
 * Opens a share code: the wire and its views from the end of a link, without the core. Twin of the reading half of
 * `src/export/share/mod.rs`; a code is base64url of `[version][range-coded contents][CRC-32 of all before]`.
 */

import type { WireShape } from "../scene/shape";
import type { View } from "../scene/view";
import { crc32, fromBase64 } from "./base64";
import { isView, wireProblem } from "./check";
import { codesIn, type Found } from "./pasted";
import { readContents } from "./contents";
import { knotsFrom, pointsFrom } from "./knots";
import { Nonsense, RangeDecoder } from "./range";

export interface Opened {
  readonly wire: WireShape;
  readonly views: readonly View[];
  /** What it was made with. */
  readonly task: string;
  readonly seed: bigint;
}

/** Says in a sentence why a code cannot be opened, and what to do. */
export class ShareCodeError extends Error {
  override readonly name = "ShareCodeError";
}

const VERSION = 2;
/** Longer texts are refused unread: much may stand round a link. */
const MAX_TEXT_CHARACTERS = 1 << 20;
/** 64 kB; a wire of 20,000 control points needs less. */
const MAX_CODE_CHARACTERS = Math.floor((65_536 * 4) / 3) + 2;

/**
 * The wire of a share code.
 * @throws ShareCodeError for anything that is damaged, foreign or newer than this page.
 */
export function openShareCode(code: string): Opened {
  if (code.length > MAX_CODE_CHARACTERS) throw new ShareCodeError("This link is longer than any code; copy only the code or the link.");
  if (!code) throw new ShareCodeError("This link is empty; copy the whole code or link.");
  const body = bodyOf(code);
  if (!body) throw damaged();
  const version = body[0]!;
  if (version > VERSION) {
    throw new ShareCodeError(`This link was made by a newer Wire4D (version ${version}, this page reads ${VERSION}); reload the page to get it.`);
  }
  if (version === 0) throw damaged();
  return unpack(body.subarray(1), version);
}

/** The code in a pasted text, with what stands round it; null where nothing is like one. A whole one, if there is one. */
export function codeIn(text: string): (Found & { readonly whole: boolean }) | null {
  if (text.length > MAX_TEXT_CHARACTERS) return null;
  const found = codesIn(text);
  const whole = found.find(({ code }) => bodyOf(code));
  const best = whole ?? found[0];
  return best ? { ...best, whole: best === whole } : null;
}

/** What is in a code, if its checksum is right. */
function bodyOf(code: string): Uint8Array | null {
  const bytes = code.length > MAX_CODE_CHARACTERS ? null : fromBase64(code);
  if (!bytes || bytes.length < 5) return null;
  const body = bytes.subarray(0, -4);
  return crc32(body) === new DataView(bytes.buffer).getUint32(body.length, true) ? body : null;
}

function unpack(packed: Uint8Array, version: number): Opened {
  try {
    const { form, closed, steps, points, knots: code, views, task, seed } = readContents(new RangeDecoder(packed), version);
    const controlPoints = pointsFrom(points, steps);
    const knots = knotsFrom(code, closed);
    const problem = wireProblem(form, closed, knots, controlPoints);
    if (problem) throw new ShareCodeError(`This link holds no valid wire (${problem}); ask for a new link.`);
    if (!views.every(isView)) throw damaged();
    return { wire: { closed, knots, controlPoints }, views, task, seed };
  } catch (error) {
    throw error instanceof Nonsense ? damaged() : error;
  }
}

const damaged = (): ShareCodeError => new ShareCodeError("This link is damaged or incomplete; copy the whole code or link again.");
