import { describe, expect, it } from "vitest";
import { bytes, depthPicture, planes } from "./sight";

describe("what a network is shown of a picture", () => {
  const rgba = Uint8ClampedArray.of(255, 0, 0, 255, 0, 0, 255, 255, 0, 255, 0, 0, 0, 0, 0, 255);

  it("is the means of its places, channel by channel, on white", () => {
    // Red, blue; nothing, black.
    expect(Array.from(planes({ width: 2, height: 2, rgba }, 2, 2))).toEqual([1, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0]);
    expect(Array.from(planes({ width: 2, height: 2, rgba }, 1, 1))).toEqual([0.5, 0.25, 0.5]);
    expect(Array.from(planes({ width: 2, height: 2, rgba }, 4, 1).subarray(0, 4))).toEqual([1, 1, 0, 0]);
  });
});

describe("what it answers", () => {
  it("is held between 0 and 1 as a mask", () => {
    expect(Array.from(bytes(Float32Array.of(-1, 0.5, 2)))).toEqual([0, 128, 255]);
  });

  it("becomes a picture of the picture's size, the nearest white, whatever its scale", () => {
    const red = (values: number[], width: number, [across, down]: [number, number]) =>
      Array.from(depthPicture({ by: "", width, height: values.length / width, values: Float32Array.from(values) }, across, down)).filter((_, i) => i % 4 === 0);
    expect(red([-3, 7, 2, -3], 2, [2, 2])).toEqual([0, 255, 128, 0]);
    expect(red([10, 20], 2, [4, 1])).toEqual([0, 64, 191, 255]);
    expect(red([5, 5], 2, [2, 1])).toEqual([0, 0]);
  });
});
