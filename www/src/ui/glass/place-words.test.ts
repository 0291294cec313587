import { expect, it } from "vitest";
import type { View } from "../../engine/protocol";
import { viewFrom } from "../../view/heading";
import type { Profile } from "../../view/profile";
import { placeWords } from "./place-words";

const view: View = { ...viewFrom({ azimuth: 0, elevation: 0 }, "front"), height_world: 2.56 };
/** 2 world units long: 1 is 100 mm. */
const profile: Profile = {
  count: 2,
  places: Float32Array.of(-1, 0, 0, 1, 0, 0),
  widths: Float32Array.of(0.04, 0.04),
  curvatures: Float32Array.of(5, 0),
  shares: Float32Array.of(0.25, 0.75),
  length: 2,
};

it("says where a place is, how it bends and how thick it is, in diameters, pixels and millimetres", () => {
  expect(placeWords(profile, 0, [view])).toBe("25% along · bend radius 5.0 diameters (20 px, 20 mm) · 4.0 px, 4.0 mm thick");
  expect(placeWords(profile, 1, [view])).toBe("75% along · straight · 4.0 px, 4.0 mm thick");
});

it("leaves out pixels where no view has one scale", () => {
  const { height_world: _height, ...perspective } = view;
  expect(placeWords(profile, 1, [perspective])).toBe("75% along · straight · 4.0 mm thick");
});
