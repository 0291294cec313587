/**
 * A page with the element and nothing else, for frames: filled by its fragment, driven by the page that frames it. Its one
 * script lies in the page and runs once more in the worker that draws.
 */

import { WireSculpture } from "#sculpture/index";
import { answering } from "./answering";
import { readEmbed, readOrigin } from "./fragment";
import type { Sculpture } from "./sculpture";

if (typeof document !== "undefined") begin();

function begin(): void {
  const script = document.querySelector("script")!.textContent;
  if (script) WireSculpture.workerUrl = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
  const sculpture = document.querySelector<Sculpture>("wire-sculpture")!;
  fill(sculpture);
  addEventListener("hashchange", () => fill(sculpture));
  const origin = readOrigin(location.search);
  if (origin !== null && parent !== window) answering(sculpture, parent, origin);
}

function fill(sculpture: Sculpture): void {
  const attributes = readEmbed(location.hash, location.href);
  for (const { name } of [...sculpture.attributes]) if (!(name in attributes)) sculpture.removeAttribute(name);
  for (const [name, value] of Object.entries(attributes)) if (sculpture.getAttribute(name) !== value) sculpture.setAttribute(name, value);
}
