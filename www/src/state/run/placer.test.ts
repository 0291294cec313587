import { beforeEach, expect, it } from "vitest";
import { Problem } from "../../engine/client";
import type { Backend, Place } from "../../engine/protocol";
import type { Whereabouts } from "../contract/state";
import { Placer } from "./placer";

const CPU: Place = { backend: "cpu", device: "processor", why: "The processor does the work." };
const GPU: Place = { backend: "gpu", device: "Card", why: "The graphics card does the work." };

let where: Whereabouts;
let notices: string[];
let asked: { backend: Backend; answer(place: Place): void; refuse(error: Error): void }[];
let placer: Placer;

beforeEach(() => {
  notices = [];
  asked = [];
  placer = new Placer(
    (backend) => new Promise((answer, refuse) => asked.push({ backend, answer, refuse })),
    (now) => (where = now),
    (words) => notices.push(words),
  );
});

const settled = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));
/** Answers the newest question. */
const answer = (place: Place): Promise<void> => {
  asked.at(-1)!.answer(place);
  return settled();
};
const refuse = (error: Error): Promise<void> => {
  asked.at(-1)!.refuse(error);
  return settled();
};

it("asks when the setting changes, and only the newest answer counts", async () => {
  placer.follow("auto");
  placer.follow("auto");
  placer.follow("gpu");
  expect(asked.map(({ backend }) => backend)).toEqual(["auto", "gpu"]);
  await answer(GPU);
  asked[0]!.answer(CPU);
  await settled();
  expect(where).toEqual({ asked: "gpu", byAddress: false, place: GPU, refusal: "" });
  expect(await placer.begin("gpu")).toBe("gpu");
  expect(notices).toEqual([]);
});

it("takes the processor where the graphics card is refused, and says why", async () => {
  placer.follow("gpu");
  const begun = placer.begin("gpu");
  await refuse(new Problem("this browser has no WebGPU"));
  await answer(CPU);
  expect(where).toMatchObject({ place: CPU, refusal: "This browser has no WebGPU." });
  expect(await begun).toBe("cpu");
  expect(notices).toEqual(["This browser has no WebGPU. The processor is used instead."]);
  placer.end(false);
  placer.follow("cpu");
  await answer(CPU);
  expect(where.refusal).toBe("");
  // Called off before there was an answer.
  const off = placer.begin("gpu");
  placer.end(false);
  await refuse(new Problem("this browser has no WebGPU"));
  await answer(CPU);
  await off;
  expect(notices).toHaveLength(1);
});

it("obeys the address, whatever the setting is", async () => {
  placer.obey("cpu");
  placer.follow("gpu");
  placer.follow("auto");
  expect(asked.map(({ backend }) => backend)).toEqual(["cpu"]);
  await answer(CPU);
  expect(where).toMatchObject({ asked: "cpu", byAddress: true, place: CPU });
  expect(await placer.begin("gpu")).toBe("cpu");
});

it("waits for no answer where nothing can be refused", async () => {
  expect(await placer.begin("auto")).toBe("auto");
  placer.hear(CPU);
  // Comes late, and is not where this run is.
  await answer(GPU);
  expect(where.place).toEqual(CPU);
});

it("tells of a move on the way, and asks anew when the run is over", async () => {
  placer.follow("auto");
  await answer(GPU);
  await placer.begin("auto");
  // The same, in the run's own words.
  placer.hear({ ...GPU, why: "It passed its check." });
  expect(notices).toEqual([]);
  placer.hear({ ...GPU, why: "the graphics card was lost; the run goes on anew" });
  placer.hear({ ...CPU, why: "The graphics card was lost twice." });
  expect(notices).toEqual(["The graphics card was lost; the run goes on anew.", "The graphics card was lost twice."]);
  placer.end(false);
  expect(asked).toHaveLength(2);
  await answer(GPU);
  expect(where.place).toEqual(GPU);
  await placer.begin("auto");
  placer.hear(GPU);
  placer.end(false);
  expect(asked).toHaveLength(2);
  placer.end(true);
  expect(asked).toHaveLength(3);
});

it("tells when a run begins elsewhere than was said", async () => {
  placer.follow("auto");
  await answer(GPU);
  await placer.begin("auto");
  placer.hear({ ...CPU, why: "The graphics card failed its check." });
  expect(notices).toEqual(["The graphics card failed its check."]);
});

it("keeps quiet about what is told elsewhere", async () => {
  placer.follow("auto");
  await refuse(new Problem("The engine could not be loaded."));
  expect(where).toMatchObject({ place: null, refusal: "" });
  expect(notices).toEqual([]);
});
