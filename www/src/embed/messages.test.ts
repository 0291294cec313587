import { describe, expect, it } from "vitest";
import { readMessage } from "./messages";

const to = "wire-sculpture";

describe("readMessage", () => {
  it("reads every call", () => {
    expect(readMessage({ to, call: "getState", id: 7 })).toEqual({ call: "getState", id: 7 });
    expect(readMessage({ to, call: "play" })).toEqual({ call: "play", id: null });
    expect(readMessage({ to, call: "pause", id: "a" })).toEqual({ call: "pause", id: "a" });
    expect(readMessage({ to, call: "flyTo", view: "side" })).toEqual({ call: "flyTo", view: "side", id: null });
    expect(readMessage({ to, call: "setState", state: { look: "steel" } })).toEqual({ call: "setState", state: { look: "steel" }, id: null });
    expect(readMessage({ to, call: "toBlob", width: 640, height: 480, id: 1 })).toEqual({
      call: "toBlob", picture: { width: 640, height: 480, transparent: false, mimeType: "image/png" }, id: 1,
    });
  });

  it("copies a state, and leaves behind what JSON has not", () => {
    const state = { look: "steel", act: () => 1, nested: { __proto__: { x: 1 } } };
    expect(readMessage({ to, call: "setState", state })).toEqual({ call: "setState", state: { look: "steel", nested: {} }, id: null });
  });

  const round: Record<string, unknown> = {};
  round["round"] = round;
  it.each([
    null, undefined, 0, NaN, "", "getState", [], ["getState"], {}, Symbol.iterator, 1n, () => 1,
    { call: "getState" }, { to: "other", call: "getState" }, { to: [to], call: "getState" },
    { to, call: "constructor" }, { to, call: "__proto__" }, { to, call: "remove" }, { to, call: ["play"] },
    { to, call: "play", id: {} }, { to, call: "play", id: NaN }, { to, call: "play", id: "x".repeat(65) }, { to, call: "play", id: true },
    { to, call: "flyTo" }, { to, call: "flyTo", view: "" }, { to, call: "flyTo", view: 3 }, { to, call: "flyTo", view: "v".repeat(65) },
    { to, call: "setState" }, { to, call: "setState", state: null }, { to, call: "setState", state: [] }, { to, call: "setState", state: "{}" },
    { to, call: "setState", state: round }, { to, call: "setState", state: { x: 1n } }, { to, call: "setState", state: { x: "y".repeat(20_001) } },
    { to, call: "toBlob", width: 15 }, { to, call: "toBlob", width: 4097 }, { to, call: "toBlob", width: 1e9 }, { to, call: "toBlob", width: 640.5 },
    { to, call: "toBlob", height: "480" }, { to, call: "toBlob", height: NaN }, { to, call: "toBlob", transparent: 1 }, { to, call: "toBlob", mimeType: "text/html" },
  ])("ignores %s", (data) => {
    expect(readMessage(data)).toBeNull();
  });

  it("does not throw where reading does", () => {
    const trap = new Proxy({}, { get: () => { throw new Error("trap"); } });
    expect(readMessage(trap)).toBeNull();
  });
});
