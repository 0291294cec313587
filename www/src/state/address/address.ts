/** The address while a person works: it carries the settings, and a wire only as long as that is the one on the stage. */

import type { Doc } from "../keeping/document";
import { readFragment, writeFragment } from "./fragment";

/** The fragment that should stand in the address in place of `hash`. */
export function addressed(hash: string, { made, settings }: Doc): string {
  const { code } = readFragment(hash);
  return writeFragment(code !== null && made?.finished.code === code ? code : null, settings);
}
