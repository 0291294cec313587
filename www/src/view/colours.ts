/** The page's colours as canvases want them. To ask for them makes the browser work out every style: once is enough. */

export interface Colours {
  readonly ink: string;
  readonly copper: string;
  readonly amber: string;
}

let known: Colours | null = null;

export function pageColours(): Colours {
  if (!known) {
    const style = getComputedStyle(document.documentElement);
    // The text's own colour: people who force colours get theirs.
    known = { ink: style.color, copper: style.getPropertyValue("--copper"), amber: style.getPropertyValue("--amber") };
  }
  return known;
}

addEventListener("theme-change", () => (known = null));
matchMedia("(forced-colors: active)").addEventListener("change", () => (known = null));
