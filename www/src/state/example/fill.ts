/** What a first visit to the third job shows: a shape by formula with a style by formula. */

import type { Cover } from "../surface/cover";

export const FILL_COVER: Cover = { solid: { shape: "creature" }, style: "petals" };

export async function fillCode(): Promise<string | null> {
  return null;
}
