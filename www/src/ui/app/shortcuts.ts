/** The page's keys, as data: help lists them, and one function finds what a key press asks for. */

export type Action = "run" | "front" | "side" | "top" | "room" | "undo" | "redo" | "share" | "help";

export interface Shortcut {
  readonly action: Action;
  /** As help shows it. */
  readonly keys: readonly string[];
  readonly words: string;
}

export const SHORTCUTS: readonly Shortcut[] = [
  { action: "run", keys: ["Space"], words: "Run, pause or go on" },
  { action: "front", keys: ["1"], words: "Look from the front" },
  { action: "side", keys: ["2"], words: "Look from the side" },
  { action: "top", keys: ["3"], words: "Look from above" },
  { action: "room", keys: ["F"], words: "See the whole room" },
  { action: "undo", keys: ["Z", "Ctrl Z"], words: "Undo" },
  { action: "redo", keys: ["Shift Z", "Ctrl Y"], words: "Redo" },
  { action: "share", keys: ["S"], words: "Copy the link" },
  { action: "help", keys: ["?"], words: "This help" },
];

type Press = Pick<KeyboardEvent, "key" | "shiftKey" | "ctrlKey" | "metaKey" | "altKey">;

/** Keys of one letter may be switched off; those with Ctrl (or Command) stay. */
export function actionOf(press: Press, letters = true): Action | null {
  if (press.altKey) return null;
  const key = press.key.toLowerCase();
  if (press.ctrlKey || press.metaKey) {
    if (key === "z") return press.shiftKey ? "redo" : "undo";
    return key === "y" && !press.shiftKey ? "redo" : null;
  }
  if (!letters) return null;
  if (key === "z" && press.shiftKey) return "redo";
  if (key === "?") return "help";
  if (press.shiftKey) return null;
  const found = SHORTCUTS.find(({ keys }) => keys[0]!.toLowerCase() === (key === " " ? "space" : key));
  return found?.action ?? null;
}

const FIELDS = "input:not([type=checkbox], [type=radio], [type=range], [type=button]), textarea, select, [contenteditable]";
/** Keys belong to whatever these are. */
const OWN_KEYS = "dialog, pad-editor canvas, pad-editor [role=grid], [role=menu], [role=listbox], [data-keys]";
const PRESSABLE = "button, summary, a[href], input, [role=tab], [role=button]";

/** Whether what has the focus wants this key for itself. `path` is the event's composed path. */
export function isTaken(path: readonly EventTarget[], action: Action): boolean {
  const elements = path.filter((target): target is Element => target instanceof Element);
  const is = (selector: string): boolean => elements.some((element) => element.matches(selector));
  if (is(FIELDS)) return true;
  // Undo and redo go over strokes of the pen, too.
  if (is(OWN_KEYS)) return action !== "undo" && action !== "redo";
  return action === "run" && elements[0]?.matches(PRESSABLE) === true;
}
