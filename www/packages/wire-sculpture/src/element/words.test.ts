import { expect, it } from "vitest";
import { orbitOf } from "./orbit-text";
import { WORDS, wordsOf } from "./words";

it("takes other words, where they are words", () => {
  expect(wordsOf(null)).toEqual(WORDS);
  expect(wordsOf(`{"front":"Vorne","side":7}`)).toEqual({ ...WORDS, front: "Vorne" });
  for (const none of ["{", "7", "null", "[]"]) expect(wordsOf(none)).toEqual(WORDS);
});

it("reads where a camera is to be, and nothing that is no such place", () => {
  const { azimuthRad, elevationRad, away } = orbitOf("35deg -20deg 105%")!;
  expect([azimuthRad, elevationRad, away].map((x) => Math.round(x! * 1000) / 1000)).toEqual([0.611, -0.349, 1.05]);
  expect(orbitOf("1rad 0 auto")).toMatchObject({ azimuthRad: 1, away: 1 });
  expect(orbitOf("0deg 900deg 9999%")).toMatchObject({ elevationRad: Math.PI / 2, away: 5 });
  for (const none of ["", "35deg", "a b c", "1deg 2deg 3m", "NaN 0deg", "1deg 2deg -5%"]) expect(orbitOf(none)).toBeNull();
});
