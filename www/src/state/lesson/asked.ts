/**
 * What an address asks of a lesson or for a class: `#lesson=ID&step=3&lock=seed,preset&hide=share,settings&kiosk=1`, beside
 * everything else that an address may say. Without a lesson it locks and hides on the page as it is.
 */

import type { Locks } from "../common/locks";

export interface Asked extends Locks {
  readonly lesson: string | null;
  /** As people count; null where none is named. */
  readonly step: number | null;
  readonly kiosk: boolean;
}

const KEYS = ["lesson", "step", "lock", "hide", "kiosk"] as const;

export function readAsked(hash: string): Asked {
  const pairs = new URLSearchParams(hash.replace(/^#/, ""));
  const names = (key: string): readonly string[] => [...new Set((pairs.get(key) ?? "").split(",").map((name) => name.trim()).filter(Boolean))];
  const step = pairs.get("step");
  return { lesson: pairs.get("lesson"), step: step === null ? null : Number(step), lock: names("lock"), hide: names("hide"), kiosk: pairs.get("kiosk") === "1" };
}

/** A fragment that asks for it, in place of what `hash` asked; empty where neither says anything. */
export function writeAsked(hash: string, { lesson, step, lock, hide, kiosk }: Asked): string {
  const rest = hash.replace(/^#/, "").split("&").filter((pair) => pair && !KEYS.some((key) => pair.startsWith(`${key}=`)) && !pair.startsWith("v="));
  const asked = [
    ...(lesson === null ? [] : [`lesson=${lesson}`]),
    ...(step === null ? [] : [`step=${step}`]),
    ...(lock.length ? [`lock=${lock.join(",")}`] : []),
    ...(hide.length ? [`hide=${hide.join(",")}`] : []),
    ...(kiosk ? ["kiosk=1"] : []),
  ];
  const all = [...asked, ...rest];
  return all.length ? `#v=1&${all.join("&")}` : "";
}
