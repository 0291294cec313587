/** Keys of a row of tabs: arrows, Home and End go to another one, which gets chosen and focused. */

/** Tabs have the ids `tab-…`. Goes on from the tab that has the focus: what is drawn as chosen may be a frame behind. */
export function walkTabs<T extends string>(event: KeyboardEvent, tabs: readonly T[], choose: (tab: T) => void): void {
  const list = event.currentTarget as Element;
  const right = getComputedStyle(list).direction === "rtl" ? "ArrowLeft" : "ArrowRight";
  const at = tabs.findIndex((tab) => (event.target as Element).id === `tab-${tab}`);
  const next = { Home: 0, End: tabs.length - 1 }[event.key] ?? (/^Arrow(Left|Right)$/.test(event.key) ? at + (event.key === right ? 1 : -1) : null);
  if (at < 0 || next === null) return;
  event.preventDefault();
  const tab = tabs.at(next % tabs.length)!;
  choose(tab);
  list.querySelector<HTMLElement>(`#tab-${tab}`)?.focus();
}
