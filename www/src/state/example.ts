/**
 * What a first visit shows: three drawings, and the wire made of them with the usual settings, as a share code
 * (`wire4d multiview` over `example/`, then `wire4d share`), and how well it matches (`views` of its report). Read without the core, so that it is there at once.
 */

import front from "./example/front.png?url";
import side from "./example/side.png?url";
import top from "./example/top.png?url";
import codeUrl from "./example.code?url";
import measured from "./example.json";
import type { ViewMeasures } from "../engine/protocol";
import { SLOTS, type Slot } from "./document";
import { nextTask } from "./next-task";
import { PAPER_PX, type Paper } from "./paper";

/** `tests/drawings/t01-animals`, each already on its sheet: scaling them here would keep a slow page busy. */
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

export async function examplePapers(): Promise<Record<Slot, Paper>> {
  const bitmaps = SLOTS.map(async (slot) => createImageBitmap(await (await fetched(DRAWINGS[slot].url)).blob()));
  const papers: [Slot, Paper][] = [];
  for (const [i, slot] of SLOTS.entries()) {
    const bitmap = await bitmaps[i]!;
    await nextTask();
    papers.push([slot, paper(bitmap, DRAWINGS[slot].label)]);
  }
  return Object.fromEntries(papers) as Record<Slot, Paper>;
}

/** Dark lines on white become ink; no finder is needed for drawings that we made ourselves. */
function paper(bitmap: ImageBitmap, label: string): Paper {
  const context = new OffscreenCanvas(PAPER_PX, PAPER_PX).getContext("2d", { willReadFrequently: true })!;
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const { data } = context.getImageData(0, 0, PAPER_PX, PAPER_PX);
  const ink = new Uint8Array(PAPER_PX * PAPER_PX);
  for (let i = 0; i < ink.length; i++) ink[i] = 255 - data[4 * i]!;
  return { label, layers: [{ kind: "stamp", label, ink }] };
}

async function fetched(url: string): Promise<Response> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  return response;
}
