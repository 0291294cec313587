/** Everything with a key, and what only the page can do: look from somewhere, share, help. */

import { msg } from "@lit/localize";
import { deskOf } from "../../state/keeping/document";
import type { ViewName } from "#sculpture/scene/stage";
import type { Action, Parts } from "../../state/actions/action";
import { pause, redo, run, undo, useTool } from "../../state/actions/actions";

/** What the page's own actions work with, besides the studio's parts. */
export interface PageParts extends Parts {
  flyTo(view: ViewName): void;
  share(): void;
  help(): void;
}

export type PageAction = Action<[], PageParts>;

const look = (view: ViewName, key: string, help: string): PageAction => ({ id: `look-${view}`, label: help, keys: [key], help, act: (page) => page.flyTo(view) });

export const share: PageAction = {
  id: "share",
  part: "share",
  label: msg("Share"),
  keys: ["S"],
  help: msg("Share the wire"),
  can: ({ doc, phase }) => phase === "idle" && deskOf(doc).made !== null,
  act: (page) => page.share(),
};

/** Opens the optimiser beside the stage, or closes it. */
export const glass: PageAction = {
  id: "glass",
  part: "glass",
  label: msg("Glass box"),
  keys: ["G"],
  help: msg("Open the optimiser, or close it"),
  act: (page) => {
    const { store } = page.bench;
    const isOpen = store.get().tool === "glass";
    useTool.act(page, isOpen ? null : "glass");
    store.set({ said: isOpen ? msg("The glass box is closed.") : msg("The glass box is open beside the stage.") });
  },
};

/** Takes the wire in hand, or leaves it. */
export const hands: PageAction = {
  id: "hands",
  part: "hands",
  label: msg("Hands on"),
  keys: ["E"],
  help: msg("Take the wire in hand, or leave it"),
  act: (page) => {
    const { store } = page.bench;
    const isOpen = store.get().tool === "hands";
    useTool.act(page, isOpen ? null : "hands");
    store.set({ said: isOpen ? msg("The wire is left as it is.") : msg("The wire is in hand: choose a point beside the stage.") });
  },
};

export const help: PageAction = { id: "help", label: msg("Help"), keys: ["?"], help: msg("This help"), act: (page) => page.help() };

/** In the order of help's list. */
export const ACTIONS: readonly PageAction[] = [
  run,
  pause,
  look("front", "1", msg("Look from the front")),
  look("side", "2", msg("Look from the side")),
  look("top", "3", msg("Look from above")),
  look("room", "F", msg("See the whole room")),
  undo,
  redo,
  share,
  glass,
  hands,
  help,
];
