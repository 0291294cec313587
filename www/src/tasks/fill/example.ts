/**
 * What a first visit to the third job shows: a shape by formula in a style by formula, and the wire that covers it with
 * the usual settings, as a share code (what the page's own link carries). Loaded when that job is first looked at.
 */

import type { Cover } from "./given";
import { fetched } from "../../state/common/fetched";
import codeUrl from "./example/wire.code?url";

export const FILL_COVER: Cover = { solid: { shape: "creature" }, style: "petals" };

export async function fillCode(): Promise<string> {
  return (await fetched(codeUrl)).text().then((text) => text.trim());
}
