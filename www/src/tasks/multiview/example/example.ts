/**
 * What a first visit shows: three drawings, and the wire made of them with the usual settings, as a share code
 * (`wire4d multiview` over the drawings beside it, then `wire4d share`), and how well it matches (`views` of its report).
 * Read without the core, so that it is there at once.
 */

import { msg } from "@lit/localize";
import type { EngineClient } from "../../../engine/client";
import { sheetOf } from "../../../engine/sheet";
import { codeAt, fetched } from "../../../state/common/fetched";
import type { Example } from "../../../state/contract/task";
import type { Paper } from "../paper";
import front from "./front.webp?url";
import side from "./side.webp?url";
import top from "./top.webp?url";
import measured from "./views.json";
import codeUrl from "./wire.code?url";
import { SLOTS, type Papers, type Slot } from "../given";

/** `tests/drawings/t01-animals`, each already on its sheet, in eight shades; WebP without loss, which is smaller than PNG. */
const DRAWINGS: Readonly<Record<Slot, { url: string; label: string }>> = {
  front: { url: front, label: msg("Cat") },
  side: { url: side, label: msg("Bird") },
  top: { url: top, label: msg("Fish") },
};

export async function example(engine: EngineClient): Promise<Example<Papers>> {
  const [code, given] = await Promise.all([codeAt(codeUrl), papers(engine)]);
  return { code, given, measured };
}

async function papers(engine: EngineClient): Promise<Papers> {
  const papers = SLOTS.map(async (slot): Promise<[Slot, Paper]> => {
    const { url, label } = DRAWINGS[slot];
    const drawing = await (await fetched(url)).blob();
    // Aside, as codes are; here where there is no worker.
    const { ink } = await engine.call("sheet", { drawing }).catch(() => sheetOf(drawing));
    return [slot, { label, layers: [{ kind: "stamp", label, ink }] }];
  });
  return Object.fromEntries(await Promise.all(papers)) as Record<Slot, Paper>;
}
