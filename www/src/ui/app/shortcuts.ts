/** The page's keys: finds the action that a key press asks for. */

import type { StudioState } from "../../state/studio";
import { ACTIONS, type PageAction } from "./actions";

type Press = Pick<KeyboardEvent, "key" | "shiftKey" | "ctrlKey" | "metaKey" | "altKey">;

/**
 * Of actions with the same key, the one that can be done now. Keys of one letter may be switched off; those with Ctrl (or
 * Command) stay.
 */
export function actionOf(press: Press, state: StudioState, letters = true): PageAction | null {
  if (press.altKey) return null;
  const ctrl = press.ctrlKey || press.metaKey;
  if (!ctrl && !letters) return null;
  const pressed = press.key === " " ? "space" : press.key.toLowerCase();
  // A sign may need Shift to be written at all. With Ctrl, Shift asks for what the letter does with it.
  const shift = press.shiftKey && pressed !== "?" ? "shift " : "";
  const asked = ctrl && !shift ? `ctrl ${pressed}` : `${shift}${pressed}`;
  const found = ACTIONS.filter(({ keys = [] }) => keys.some((key) => key.toLowerCase() === asked));
  if (ctrl && shift && !found.some(({ keys = [] }) => keys.some((key) => key.startsWith("Ctrl")))) return null;
  return found.find(({ can }) => can?.(state) ?? true) ?? found[0] ?? null;
}

const FIELDS = "input:not([type=checkbox], [type=radio], [type=range], [type=button]), textarea, select, [contenteditable]";
/** Keys belong to whatever these are. */
const OWN_KEYS = "dialog, pad-editor canvas, pad-editor [role=grid], [role=menu], [role=listbox], [data-keys]";
const PRESSABLE = "button, summary, a[href], input, [role=tab], [role=button]";

/** Whether what has the focus wants this key for itself. `path` is the event's composed path. */
export function isTaken(path: readonly EventTarget[], { keys, everywhere = false }: Pick<PageAction, "keys" | "everywhere">): boolean {
  const elements = path.filter((target): target is Element => target instanceof Element);
  const is = (selector: string): boolean => elements.some((element) => element.matches(selector));
  if (is(FIELDS)) return true;
  // Undo and redo go over strokes of the pen, too.
  if (is(OWN_KEYS)) return !everywhere;
  return keys?.includes("Space") === true && elements[0]?.matches(PRESSABLE) === true;
}
