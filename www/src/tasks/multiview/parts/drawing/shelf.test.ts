import { describe, expect, it } from "vitest";
import { find } from "./shelf";
import { icons } from "./shelf-icons";

const names = (query: string): readonly string[] => find(icons, query).map(({ name }) => name);

describe("the icon shelf", () => {
  it("takes plain words", () => {
    expect(names("cat").slice(0, 1)).toEqual(["cat"]);
    expect(names("bike")[0]).toBe("bike");
    expect(names("love").slice(0, 8)).toContain("heart");
    expect(names("Bicycle")[0]).toBe("bike");
  });

  it("puts names before tags and beginnings before middles", () => {
    const shelf = ["scar", "oscar", "car", "car-front", "bus"].map((name) => ({ name, tags: name === "bus" ? ["car"] : [] }));
    expect(find(shelf, "car").map(({ name }) => name)).toEqual(["car", "car-front", "bus", "scar", "oscar"]);
  });

  it("tolerates plurals", () => {
    expect(names("cats")).toContain("cat");
    expect(names("cherries")).toContain("cherry");
    expect(names("boxes")).toContain("box");
    expect(names("glasses")[0]).toBe("glasses");
  });

  it("wants every word", () => {
    expect(names("arrow up")[0]).toBe("arrow-up");
    expect(names("zebra crossing spaceship")).toEqual([]);
  });

  it("shows everything when nothing is asked for", () => {
    expect(names("  ").length).toBe(icons.length);
  });
});
