/** A page with the element and nothing else, for frames: filled by its fragment, driven by the page that frames it. */

import "#sculpture/index";
import { readEmbed, readOrigin } from "./fragment";
import { answering } from "./answering";
import type { Sculpture } from "./sculpture";

const sculpture = document.querySelector<Sculpture>("wire-sculpture")!;

function fill(): void {
  const attributes = readEmbed(location.hash, location.href);
  for (const { name } of [...sculpture.attributes]) if (!(name in attributes)) sculpture.removeAttribute(name);
  for (const [name, value] of Object.entries(attributes)) if (sculpture.getAttribute(name) !== value) sculpture.setAttribute(name, value);
}

fill();
addEventListener("hashchange", fill);
const origin = readOrigin(location.search);
if (origin !== null && parent !== window) answering(sculpture, parent, origin);
