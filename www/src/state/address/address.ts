/** The address while a person works: it carries task, settings and what guides, and a wire only as long as that is the one on the stage. */

import { deskOf, type Doc } from "../keeping/document";
import { readFragment, writeFragment, type Named } from "./fragment";
import { writeGuide } from "../settings/guide-pairs";

/** The fragment that should stand in the address in place of `hash`; `madeOf` is what the finished wire was made of, if known. */
export function addressed(hash: string, doc: Doc, tasks: readonly Named[], madeOf: unknown = null): string {
  const { made, settings, guide } = deskOf(doc);
  const { code } = readFragment(hash, tasks);
  const carried = code !== null && made?.finished.code === code;
  const given = carried ? madeOf : doc.given[doc.task];
  const address = tasks.find(({ name }) => name === doc.task)?.address;
  return writeFragment(doc.task, carried ? code : null, { ...settings, ...writeGuide(guide) }, given ? (address?.write(given) ?? {}) : {}, tasks);
}
