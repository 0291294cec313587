/** The gallery as it hangs below the app: posters and words; a click leads to the gallery itself. */

import works from "../../gallery/works.json";
import "./cards.css";
import "./below.css";
import { sayIn } from "../words/told";
import { cards } from "./cards";
import type { Work } from "./works";

export function hang(section: Element): void {
  section.innerHTML = `<div><h2 data-words>Gallery</h2><p data-words>All of these are one wire each, made here. Open one to turn it, to see how it was found, or to make it yours.</p>${cards(works as readonly Work[], "./gallery.html#")}</div>`;
  sayIn(document);
}
