/** What of a sculpture is seen in a picture. */

import type { Page } from "playwright-core";

/** Shares of a picture's pixels that are copper, however it is lit, and of the colour of marks. */
export function coloursIn(page: Page, png: string): Promise<{ copper: number; marks: number }> {
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes]));
    const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d")!;
    context.drawImage(bitmap, 0, 0);
    const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
    let [copper, marks] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      const [red, green, blue] = [data[i]!, data[i + 1]!, data[i + 2]!];
      if (red - green > 25 && red - blue > 50) copper++;
      if (red - green > 120 && blue - green > 30) marks++;
    }
    return { copper: copper / (data.length / 4), marks: marks / (data.length / 4) };
  }, png);
}

/** Writes down a sculpture's context as `lent`, to be taken away. */
export const LEND = `for (const { prototype } of [globalThis.HTMLCanvasElement, OffscreenCanvas].filter(Boolean)) {
  const getContext = prototype.getContext;
  prototype.getContext = function (kind, ...rest) {
    const context = getContext.call(this, kind, ...rest);
    if (kind === "webgl2") globalThis.lent = context.getExtension("WEBGL_lose_context");
    return context;
  };
}`;
