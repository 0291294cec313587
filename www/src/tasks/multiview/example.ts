/**
 * What a first visit shows: three drawings, and the wire made of them with the usual settings, as a share code
 * (`wire4d multiview` over the drawings beside this file, then `wire4d share`), and how well it matches (`views` of its
 * report). Read without the core, so that it is there at once.
 */

import type { Ink } from "../../engine/protocol";
import { fetched } from "../../state/common/fetched";
import front from "./example/front.png?url";
import side from "./example/side.png?url";
import top from "./example/top.png?url";
import codeUrl from "./example/wire.code?url";
import measured from "./example/views.json";
import type { ViewMeasures } from "../../engine/protocol";
import { SLOTS, type Slot } from "../../state/keeping/document";
import type { Paper } from "./drawing/paper";

/** `tests/drawings/t01-animals`, each already on its sheet. */
const DRAWINGS: Readonly<Record<Slot, { url: string; label: string }>> = {
  front: { url: front, label: "Cat" },
  side: { url: side, label: "Bird" },
  top: { url: top, label: "Fish" },
};

/** A link does not carry its drawings, so the core cannot measure this. */
export const EXAMPLE_VIEWS: readonly ViewMeasures[] = measured;

export async function exampleCode(): Promise<string> {
  return (await fetched(codeUrl)).text().then((text) => text.trim());
}

/** `read` finds the ink of such a drawing. */
export async function examplePapers(read: (drawing: Blob) => Promise<Ink>): Promise<Record<Slot, Paper>> {
  const papers = SLOTS.map(async (slot): Promise<[Slot, Paper]> => {
    const { url, label } = DRAWINGS[slot];
    const { ink } = await read(await (await fetched(url)).blob());
    return [slot, { label, layers: [{ kind: "stamp", label, ink }] }];
  });
  return Object.fromEntries(await Promise.all(papers)) as Record<Slot, Paper>;
}
