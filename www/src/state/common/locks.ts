/** What a lesson, or a link for a class, locks and hides: parts of the page, what people do, and settings, each by its name. */

/** Settings go by the core's names. */
export const PARTS = ["pads", "run", "result", "settings", "save", "share", "tabs", "glass", "hands", "timeline", "gallery", "undo", "files", "leave"] as const;
export type Part = (typeof PARTS)[number];

export interface Locks {
  /** Seen, but not to be used. */
  readonly lock: readonly string[];
  /** Not even seen. */
  readonly hide: readonly string[];
}

export const NO_LOCKS: Locks = { lock: [], hide: [] };

interface Locked {
  readonly locks: Locks;
}

export const isHidden = ({ locks }: Locked, name: string): boolean => locks.hide.includes(name);

/** What is hidden is locked, too: no key gets at it. */
export const isLocked = (state: Locked, name: string): boolean => state.locks.lock.includes(name) || isHidden(state, name);

/** Whether a setting stays as it is: on its own, or with all of them. */
export const isSettingLocked = (state: Locked, name: string): boolean => isLocked(state, name) || isLocked(state, "settings");

export function joined(...all: readonly Partial<Locks>[]): Locks {
  const names = (which: keyof Locks): readonly string[] => [...new Set(all.flatMap((locks) => locks[which] ?? []))];
  return { lock: names("lock"), hide: names("hide") };
}
