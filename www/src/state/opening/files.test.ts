import { expect, it } from "vitest";
import { sortFiles } from "./files";

const file = (name: string, type = "image/png"): File => new File(["x"], name, { type });

it("takes three pictures of fifty and says so", () => {
  const { pictures, note } = sortFiles(Array.from({ length: 50 }, (_, i) => file(`${i}.png`)), [], 3);
  expect(pictures.map(({ name }) => name)).toEqual(["0.png", "1.png", "2.png"]);
  expect(note).toBe("There are three pads; the first three of 50 files were taken.");
  expect(sortFiles([file("a.png"), file("b.png")], [], 1).note).toBe("One picture at a time: the first of 2 files was taken.");
});

it("opens a wire, and turns films away by name", () => {
  const { pictures, wire, note } = sortFiles([file("my.wire.json", "application/json"), file("cat.mp4", "video/mp4")], [], 3);
  expect(pictures).toEqual([]);
  expect(wire!.name).toBe("my.wire.json");
  expect(note).toContain("cat.mp4");
  expect(sortFiles([file("a.png")], [], 3).note).toBe("");
});

it("knows a folder from a picture", () => {
  const { pictures, note } = sortFiles([file("holiday", ""), file("a.png")], ["holiday"], 3);
  expect(pictures.map(({ name }) => name)).toEqual(["a.png"]);
  expect(note).toContain("holiday is a folder");
});

it("knows a mesh by its name, and where one is wanted takes whatever is no picture for one", () => {
  const files = [file("bunny.OBJ", ""), file("petals.png"), file("cup.stl", "model/stl")];
  const { meshes, pictures, note } = sortFiles(files, [], 1);
  expect([meshes, pictures].map((found) => found.map(({ name }) => name))).toEqual([["bunny.OBJ"], ["petals.png"]]);
  expect(note).toBe("One mesh at a time: bunny.OBJ was taken.");
  expect(sortFiles([file("scan.pts", "")], [], 1).meshes).toEqual([]);
  expect(sortFiles([file("scan.pts", "")], [], 1, true).meshes).toHaveLength(1);
});
