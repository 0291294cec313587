/** Light or dark: as the system says, unless a person chose otherwise. */

import { remember, remembered } from "../../state/common/remember";

export const THEMES = ["system", "light", "dark"] as const;
export type Theme = (typeof THEMES)[number];

export const nextTheme = (theme: Theme): Theme => THEMES[(THEMES.indexOf(theme) + 1) % THEMES.length]!;

const systemDark = matchMedia("(prefers-color-scheme: dark)");

export function theme(): Theme {
  const kept = remembered("theme");
  return THEMES.find((theme) => theme === kept) ?? "system";
}

export const isDark = (): boolean => (theme() === "system" ? systemDark.matches : theme() === "dark");

export function chooseTheme(chosen: Theme): void {
  remember("theme", chosen);
  apply();
}

/** Puts the choice on the page, and tells whoever paints (a `theme-change` on the window) now and when the system changes. */
function apply(): void {
  const chosen = theme();
  if (chosen === "system") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = chosen;
  dispatchEvent(new CustomEvent("theme-change", { detail: { dark: isDark() } }));
}

export function startTheme(): void {
  systemDark.addEventListener("change", apply);
  apply();
}
