/**
 * What a first visit shows: a shape by formula in a style by formula, and the wire that covers it with the usual settings,
 * as a share code (what the page's own link carries). Loaded when the task is first looked at.
 */

import { codeAt } from "../../../state/common/fetched";
import type { Example } from "../../../state/contract/task";
import codeUrl from "./wire.code?url";
import type { Cover } from "../given";

const COVER: Cover = { mesh: { shape: "creature" }, style: "petals" };

export async function example(): Promise<Example<Cover>> {
  return { code: await codeAt(codeUrl), given: COVER, measured: [] };
}
