/**
 * What a first visit shows: three drawings, and the wire made of them with the usual settings, as a share code
 * (`wire4d multiview`, then `wire4d share`). Read without the core, so that it is there at once.
 */

import front from "../../../tests/drawings/t01-animals/front.png?url";
import side from "../../../tests/drawings/t01-animals/side.png?url";
import top from "../../../tests/drawings/t01-animals/top.png?url";
import codeUrl from "./example.code?url";
import { SLOTS, type Slot } from "./document";
import { nextTask } from "./next-task";
import { PAPER_PX, type Paper } from "./paper";

/** The longer side of a drawing on its sheet. */
const FILLED_PX = 480;

const DRAWINGS: Readonly<Record<Slot, { url: string; label: string; size: ImageBitmapOptions }>> = {
  front: { url: front, label: "Cat", size: { resizeHeight: FILLED_PX } },
  side: { url: side, label: "Bird", size: { resizeWidth: FILLED_PX } },
  top: { url: top, label: "Fish", size: { resizeWidth: FILLED_PX } },
};

export async function exampleCode(): Promise<string> {
  return (await fetched(codeUrl)).text().then((text) => text.trim());
}

export async function examplePapers(): Promise<Record<Slot, Paper>> {
  const bitmaps = SLOTS.map(async (slot) => {
    const { url, size } = DRAWINGS[slot];
    return createImageBitmap(await (await fetched(url)).blob(), { ...size, resizeQuality: "high" });
  });
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
  context.fillStyle = "#fff";
  context.fillRect(0, 0, PAPER_PX, PAPER_PX);
  context.drawImage(bitmap, Math.round((PAPER_PX - bitmap.width) / 2), Math.round((PAPER_PX - bitmap.height) / 2));
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
