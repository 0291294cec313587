/** Keys of a row of tabs: arrows, Home and End go to another one, which gets chosen and focused. */

export function walkTabs<T extends string>(event: KeyboardEvent, tabs: readonly T[], chosen: T, choose: (tab: T) => void): void {
  const list = event.currentTarget as Element;
  const right = getComputedStyle(list).direction === "rtl" ? "ArrowLeft" : "ArrowRight";
  const at = tabs.indexOf(chosen);
  const next = { Home: 0, End: tabs.length - 1 }[event.key] ?? (/^Arrow(Left|Right)$/.test(event.key) ? at + (event.key === right ? 1 : -1) : null);
  if (next === null) return;
  event.preventDefault();
  const tab = tabs.at(next % tabs.length)!;
  choose(tab);
  list.querySelector<HTMLElement>(`#tab-${tab}`)?.focus();
}
