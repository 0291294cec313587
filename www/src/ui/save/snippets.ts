/** What somebody puts into a page of their own to show a wire there. */

import type { LookName } from "#sculpture/scene/looks";
import { escaped, written, type Attributes } from "./markup";

/** How the wire is to be shown. */
export interface Showing {
  readonly look: LookName;
  /** The metal's, as `#rrggbb`; null for the look's own. */
  readonly color: string | null;
  readonly room: boolean;
  readonly turning: boolean;
  /** Buttons that fly to each view. */
  readonly buttons: boolean;
  readonly size: Size;
}

/** In CSS pixels; without a width it is as wide as its place. */
export interface Size {
  readonly width: number | null;
  readonly height: number;
}

export interface Embedded {
  /** The folder of this site, where `embed.html` and `wire-sculpture.js` are. */
  readonly site: string;
  readonly code: string;
  readonly alt: string;
  readonly showing: Showing;
}

/** The element's attributes for it, besides where its wire is from and what it shows. */
export function attributesOf({ look, color, room, turning, buttons }: Showing): Attributes {
  const all: [string, string | boolean][] = [
    ["look", look === "copper" ? false : look],
    ["color", color !== null && isMetal(look) ? color : false],
    ["shadow", room],
    ["auto-rotate", turning],
    ["views", buttons ? "" : false],
    ["camera-controls", true],
  ];
  return all.flatMap(([name, value]) => (value === false ? [] : [[name, value === "" ? true : value] as const]));
}

/** Whether a look is of one colour. */
export const isMetal = (look: LookName): boolean => look === "copper" || look === "steel";

export function elementSnippet({ site, code, alt, showing }: Embedded): string {
  const { width, height } = showing.size;
  const style = `display: block; ${width === null ? "" : `max-width: 100%; width: ${width}px; `}height: ${height}px`;
  const attributes: Attributes = [["code", code], ["alt", alt], ...attributesOf(showing), ["style", style]];
  return `<script type="module" src="${escaped(new URL("wire-sculpture.js", site).href)}"></script>\n<wire-sculpture${written(attributes)}></wire-sculpture>`;
}

export function iframeSnippet({ site, code, alt, showing }: Embedded): string {
  const { width, height } = showing.size;
  const address = new URL("embed.html", site);
  address.hash = embedFragment(code, alt, showing);
  const attributes: Attributes = [
    ["src", address.href],
    ["title", alt],
    ["width", width === null ? "100%" : String(width)],
    ["height", String(height)],
    ["loading", "lazy"],
    ["allow", "fullscreen"],
    ["style", "border: 0; max-width: 100%"],
  ];
  return `<iframe${written(attributes)}></iframe>`;
}

/** What `embed.html` reads: the element's attributes, and the wire as `w`. */
export function embedFragment(code: string, alt: string, showing: Showing): string {
  const pairs = attributesOf(showing).filter(([name]) => name !== "camera-controls");
  return [["w", code] as const, ...pairs, ["alt", alt] as const].map(([name, value]) => (value === true ? name : `${name}=${encodeURIComponent(value)}`)).join("&");
}

/** Of a file that was saved beside the page. */
export function svgSnippet(file: string, alt: string, { width, height }: Size): string {
  return `<img${written([["src", encodeURIComponent(file)], ["alt", alt], ["width", String(width ?? height)], ["height", String(height)], ["loading", "lazy"]])}>`;
}
