/** A wire as a web page in one file: gathers what goes into it. */

import type { Saver } from "../../state/saving/saver";
import type { Attributes } from "./markup";
import { elementModule } from "./element-module";
import { selfContainedHtml } from "./self-contained";

/** Beyond this, what it can do without is left out. */
const MOST_BYTES = 300_000;

export interface Asked {
  readonly saver: Saver;
  readonly code: string;
  readonly title: string;
  readonly description: string;
  /** The view that its still picture shows. */
  readonly view: string;
}

/** @throws where the element's module cannot be had. */
export async function webPage({ saver, code, title, description, view }: Asked): Promise<Blob> {
  const [module, svg, replay] = await Promise.all([moduleText(), bare(text(saver.export("svg", view))), replayOf(saver)]);
  const nonce = btoa(String.fromCharCode(...crypto.getRandomValues(new Uint8Array(18))));
  const html = (svg: string, replay: string): Blob => {
    const attributes: Attributes = [...wire(code, replay), ["alt", description], ["camera-controls", true], ["shadow", true], ["views", true]];
    return new Blob([selfContainedHtml({ module, attributes, title, description, svg, nonce })], { type: "text/html" });
  };
  return [html(svg, replay), html("", replay), html("", "")].find(({ size }) => size <= MOST_BYTES) ?? html("", "");
}

/** As a code, or with how it was found as a file in an address. */
function wire(code: string, replay: string): Attributes {
  if (!replay) return [["code", code]];
  const capsule = JSON.stringify({ format: "wire4d", version: 1, code, replay });
  return [["src", `data:application/json,${encodeURIComponent(capsule)}`], ["replay", true]];
}

async function moduleText(): Promise<string> {
  const response = await fetch(elementModule());
  if (!response.ok) throw new Error(`wire-sculpture.js: status ${response.status}`);
  return response.text();
}

/** How the wire was found, where its file knows that; else empty. */
async function replayOf(saver: Saver): Promise<string> {
  const { replay } = JSON.parse((await text(saver.export("wire.json"))) || "{}") as { replay?: unknown };
  return typeof replay === "string" ? replay : "";
}

/** The page has the wire already. */
const bare = async (svg: Promise<string>): Promise<string> => (await svg).replace(/<metadata id="wire4d">[^<]*<\/metadata>\n?/, "");

const text = async (blob: Promise<Blob | null>): Promise<string> => (await (await blob)?.text()) ?? "";
