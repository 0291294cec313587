/**
 * What a first visit shows: a picture drawn by formula, and the wire made of it with the usual settings, as a share code
 * (`wire4d stroke` over the sample as a file, then `wire4d share`), and how well it matches (`views` of its report).
 * Loaded when the task is first looked at.
 */

import { msg } from "@lit/localize";
import { codeAt } from "../../../state/common/fetched";
import type { Example } from "../../../state/contract/task";
import { kept, readPicture } from "../../../state/picture/picture";
import measured from "./views.json";
import codeUrl from "./wire.code?url";
import type { Subject } from "../given";
import { sampleFile, SAMPLES } from "./samples";

const SAMPLE = msg("Mug");

export async function example(): Promise<Example<Subject>> {
  const [code, file] = await Promise.all([codeAt(codeUrl), sampleFile(SAMPLES.find(({ name }) => name === SAMPLE)!)]);
  const picture = kept(await readPicture(file, SAMPLE), SAMPLE);
  return { code, given: { picture, object: 1, strokes: [], found: null, depth: null }, measured };
}
