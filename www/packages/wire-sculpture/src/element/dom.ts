/** Elements made by script: no text ever becomes markup, and no style needs a page's permission. */

export type Child = Node | string | null | false;

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes (null for none) and with listeners, whose names begin with `on`. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, attributes: Readonly<Record<string, unknown>> = {}, ...children: readonly Child[]): HTMLElementTagNameMap[K] {
  return dress(document.createElement(tag), attributes, children);
}

export function svg<K extends keyof SVGElementTagNameMap>(tag: K, attributes: Readonly<Record<string, unknown>> = {}, ...children: readonly Child[]): SVGElementTagNameMap[K] {
  return dress(document.createElementNS(SVG, tag) as SVGElementTagNameMap[K], attributes, children);
}

function dress<E extends Element>(element: E, attributes: Readonly<Record<string, unknown>>, children: readonly Child[]): E {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name.slice(2), value as EventListener);
    else setAttribute(element, name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== false));
  return element;
}

/** `null` and `undefined` take it away. */
export function setAttribute(element: Element, name: string, value: unknown): void {
  if (value === null || value === undefined) element.removeAttribute(name);
  else element.setAttribute(name, String(value));
}

export const ICONS = {
  left: "M3.5 4v4h4M4 8a7 7 0 1 1-.6 4.5",
  right: "M16.5 4v4h-4M16 8a7 7 0 1 0 .6 4.5",
  closer: "M10 4v12M4 10h12",
  further: "M4 10h12",
  room: "M10 10.5V3m0 7.5L3 14.5m7-4 7 4M3 14.5V6l7-3 7 3v8.5L10 18z",
  far: "M10 3a7 7 0 1 0 0 14 7 7 0 0 0 0-14M3.2 9c2 2.6 11.6 2.6 13.6 0M5 14.5c2-1.3 3-1.5 5-1.5M10 13c2 0 3 .2 5 1.5",
  more: "M3 6h6m4 0h4M3 14h2m4 0h8M9 6a2 2 0 1 0 4 0 2 2 0 0 0-4 0M5 14a2 2 0 1 0 4 0 2 2 0 0 0-4 0",
  play: "M6 4l10 6-10 6z",
  pause: "M7 4v12M13 4v12",
} as const;

export const icon = (name: keyof typeof ICONS): SVGSVGElement => svg("svg", { class: "icon", viewBox: "0 0 20 20", "aria-hidden": "true" }, svg("path", { d: ICONS[name] }));
