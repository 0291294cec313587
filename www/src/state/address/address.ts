/** The address while a person works: it carries job and settings, and a wire only as long as that is the one on the stage. */

import { deskOf, type Doc } from "../keeping/document";
import { wordsOf, type Cover } from "../../tasks/fill/given";
import { readFragment, writeFragment } from "./fragment";

/** The fragment that should stand in the address in place of `hash`; `covered` is what the finished wire covers. */
export function addressed(hash: string, doc: Doc, covered: Cover | null = null): string {
  const { made, settings } = deskOf(doc);
  const { code } = readFragment(hash);
  const carried = code !== null && made?.finished.code === code;
  const cover = carried ? covered : doc.cover;
  return writeFragment(doc.job, carried ? code : null, settings, cover ? wordsOf(cover) : undefined);
}
