import { expect, it } from "vitest";
import type { StudioState } from "../../state/studio";
import { ACTIONS } from "./actions";
import { actionOf } from "./shortcuts";

const press = (key: string, held: { shift?: boolean; ctrl?: boolean; meta?: boolean; alt?: boolean } = {}) => ({
  key, shiftKey: held.shift ?? false, ctrlKey: held.ctrl ?? false, metaKey: held.meta ?? false, altKey: held.alt ?? false,
});
const state = (phase: StudioState["phase"]): StudioState => ({ phase, undo: null, redo: null, doc: { task: "knit", given: {}, desks: {} } }) as unknown as StudioState;
const idle = state("idle");
const asked = (pressed: ReturnType<typeof press>, letters = true): string | null => actionOf(pressed, idle, letters)?.id ?? null;

it("finds what each listed key asks for", () => {
  const listed = ACTIONS.filter(({ help }) => help);
  expect(listed.length).toBeGreaterThan(8);
  for (const { id, keys = [] } of listed) {
    expect(keys).not.toEqual([]);
    for (const words of keys) {
      const parts = words.split(" ");
      const key = parts.at(-1)!;
      const held = { shift: parts.includes("Shift") || key === "?", ctrl: parts.includes("Ctrl") };
      expect(asked(press(key === "Space" ? " " : key, held)), words).toBe(id);
    }
  }
});

it("takes the action that can be done, where a key has two", () => {
  expect(actionOf(press(" "), state("running"))?.id).toBe("pause");
  expect(actionOf(press(" "), state("paused"))?.id).toBe("pause");
});

it("leaves the browser's own keys alone", () => {
  expect(asked(press("s", { ctrl: true }))).toBeNull();
  expect(asked(press("f", { meta: true }))).toBeNull();
  expect(asked(press("1", { alt: true }))).toBeNull();
  expect(asked(press("S", { shift: true }))).toBeNull();
  expect(asked(press("Y", { ctrl: true, shift: true }))).toBeNull();
});

it("keeps undo when single letters are switched off", () => {
  expect(asked(press("z"), false)).toBeNull();
  expect(asked(press(" "), false)).toBeNull();
  expect(asked(press("z", { ctrl: true }), false)).toBe("undo");
  expect(asked(press("Z", { meta: true, shift: true }), false)).toBe("redo");
});
