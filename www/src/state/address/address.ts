/** The address while a person works: it carries job and settings, and a wire only as long as that is the one on the stage. */

import { deskOf, type Doc } from "../keeping/document";
import { wordsOf } from "../surface/cover";
import { readFragment, writeFragment } from "./fragment";

/** The fragment that should stand in the address in place of `hash`. */
export function addressed(hash: string, doc: Doc): string {
  const { made, settings } = deskOf(doc);
  const { code } = readFragment(hash);
  return writeFragment(doc.job, code !== null && made?.finished.code === code ? code : null, settings, doc.cover ? wordsOf(doc.cover) : undefined);
}
