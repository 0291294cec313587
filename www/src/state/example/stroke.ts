/**
 * What a first visit to the second job shows: a picture, and the wire made of it with the usual settings, as a share
 * code (`wire4d stroke` over the picture beside this file, then `wire4d share`), and how well it matches (`views` of its
 * report). Loaded when that job is first looked at.
 */

import type { ViewMeasures } from "../../engine/protocol";
import { kept, readPicture } from "../drawing/picture";
import type { Subject } from "../subject/subject";
import { fetched } from "./fetched";
import pictureUrl from "./cat.png?url";
import codeUrl from "./cat.code?url";
import measured from "./cat.json";

/** `tests/strokes/cat.png`, drawn by formula. */
export const STROKE_EXAMPLE = "Cat";

export async function strokeExample(): Promise<{ code: string; subject: Subject; measured: readonly ViewMeasures[] }> {
  const [code, file] = await Promise.all([fetched(codeUrl).then((response) => response.text()), fetched(pictureUrl).then((response) => response.blob())]);
  const picture = kept(await readPicture(file, STROKE_EXAMPLE), STROKE_EXAMPLE);
  return { code: code.trim(), subject: { picture, object: 1, strokes: [], found: null, depth: null }, measured };
}
