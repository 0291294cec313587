/** What people call the parts of the page that a lesson may lock or hide. */

import { msg } from "@lit/localize";
import type { Part } from "../../state/common/locks";

export function partWords(part: Part): string {
  const words: Readonly<Record<Part, string>> = {
    pads: msg("What is given: drawings, picture, shape"),
    run: msg("Run and stop"),
    result: msg("Choices and match"),
    settings: msg("All settings"),
    save: msg("Saving files"),
    share: msg("Sharing links"),
    tabs: msg("Turning to another job"),
    glass: msg("The glass box"),
    hands: msg("Hands on the wire"),
    timeline: msg("The timeline"),
    gallery: msg("Gallery and other lessons"),
    undo: msg("Undo"),
    files: msg("Dropping and pasting files"),
    leave: msg("Leaving, by links or otherwise"),
  };
  return words[part];
}
