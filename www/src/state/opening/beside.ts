/** Works of the gallery, which lie beside the page: an address names their files, `#open=gallery/works/NAME.wire.json`. */

import { msg, str } from "@lit/localize";
import { Problem } from "../../engine/client";

/** Nowhere else than in the gallery's folders. */
const PATH = /^gallery\/(?:works|inputs)\/[\w-]+(?:\.\w+)+$/;

/** In the order in which the address names them: a shape before the wire that covers it. */
export function filesBeside(hash: string): Promise<File[]> {
  return Promise.all(new URLSearchParams(hash.replace(/^#/, "")).getAll("open").map(fetched));
}

async function fetched(path: string): Promise<File> {
  const response = PATH.test(path) ? await fetch(`./${path}`).catch(() => null) : null;
  if (!response?.ok) throw new Problem(msg(str`There is no work “${path.slice(0, 80)}” in the gallery. Choose one there.`));
  return new File([await response.blob()], path.slice(path.lastIndexOf("/") + 1));
}
