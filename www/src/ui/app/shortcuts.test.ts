import { expect, it } from "vitest";
import { actionOf, SHORTCUTS } from "./shortcuts";

const press = (key: string, held: { shift?: boolean; ctrl?: boolean; meta?: boolean; alt?: boolean } = {}) => ({
  key, shiftKey: held.shift ?? false, ctrlKey: held.ctrl ?? false, metaKey: held.meta ?? false, altKey: held.alt ?? false,
});

it("finds what each listed key asks for", () => {
  for (const { action, keys } of SHORTCUTS) {
    for (const words of keys) {
      const parts = words.split(" ");
      const key = parts.at(-1)!;
      const held = { shift: parts.includes("Shift") || key === "?", ctrl: parts.includes("Ctrl") };
      expect(actionOf(press(key === "Space" ? " " : key, held)), words).toBe(action);
    }
  }
});

it("leaves the browser's own keys alone", () => {
  expect(actionOf(press("s", { ctrl: true }))).toBeNull();
  expect(actionOf(press("f", { meta: true }))).toBeNull();
  expect(actionOf(press("1", { alt: true }))).toBeNull();
  expect(actionOf(press("S", { shift: true }))).toBeNull();
});

it("keeps undo when single letters are switched off", () => {
  expect(actionOf(press("z"), false)).toBeNull();
  expect(actionOf(press(" "), false)).toBeNull();
  expect(actionOf(press("z", { ctrl: true }), false)).toBe("undo");
  expect(actionOf(press("Z", { meta: true, shift: true }), false)).toBe("redo");
});
