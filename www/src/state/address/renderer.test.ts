import { expect, it } from "vitest";
import { forOthers, readRenderer, rendererWord } from "./renderer";

it("reads what an address says, and says what is wrong with it", () => {
  expect(readRenderer("")).toEqual({ backend: null, problem: "" });
  expect(readRenderer("?a=b")).toEqual({ backend: null, problem: "" });
  expect(readRenderer("?a=b&renderer=webgpu")).toEqual({ backend: "gpu", problem: "" });
  expect(readRenderer("?renderer=cpu").backend).toBe("cpu");
  expect(readRenderer("?renderer=auto").backend).toBe("auto");
  for (const word of ["x", "", "gpu", "CPU", "constructor", "__proto__", "<b>"]) {
    const { backend, problem } = readRenderer(`?renderer=${encodeURIComponent(word)}`);
    expect(backend).toBeNull();
    expect(problem).toContain(`“${word}”`);
    expect(problem).toContain("auto, webgpu or cpu");
  }
  expect(readRenderer(`?renderer=${"x".repeat(5000)}`).problem.length).toBeLessThan(200);
  expect(["auto", "gpu", "cpu"].map((backend) => rendererWord(backend as "gpu"))).toEqual(["?renderer=auto", "?renderer=webgpu", "?renderer=cpu"]);
});

it("keeps it out of what goes to others", () => {
  expect(forOthers("https://a.example/b/?renderer=cpu#v=1")).toBe("https://a.example/b/");
  expect(forOthers("https://a.example/b/?c=d&renderer=cpu")).toBe("https://a.example/b/?c=d");
  expect(forOthers("https://a.example/b/#w=AB")).toBe("https://a.example/b/");
  expect(forOthers("https://a.example/b/?c")).toBe("https://a.example/b/?c");
});
