/**
 * What a first visit to the second job shows: a picture drawn by formula, and the wire made of it with the usual settings,
 * as a share code (`wire4d stroke` over the sample as a file, then `wire4d share`), and how well it matches (`views` of
 * its report). Loaded when that job is first looked at.
 */

import type { ViewMeasures } from "../../engine/protocol";
import { kept, readPicture } from "../../state/picture/picture";
import { sampleFile, SAMPLES } from "./samples";
import type { Subject } from "./given";
import { fetched } from "../../state/common/fetched";
import codeUrl from "./example/wire.code?url";
import measured from "./example/views.json";

const SAMPLE = "Mug";

export async function strokeExample(): Promise<{ code: string; subject: Subject; measured: readonly ViewMeasures[] }> {
  const [code, file] = await Promise.all([fetched(codeUrl).then((response) => response.text()), sampleFile(SAMPLES.find(({ name }) => name === SAMPLE)!)]);
  const picture = kept(await readPicture(file, SAMPLE), SAMPLE);
  return { code: code.trim(), subject: { picture, object: 1, strokes: [], found: null, depth: null }, measured };
}
