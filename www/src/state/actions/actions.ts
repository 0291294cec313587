/** What people can do with the document and its runs. */

import { msg, str } from "@lit/localize";
import { isLocked } from "../common/locks";
import { remember } from "../common/remember";
import type { StudioState, Tool, WhenHidden } from "../contract/state";
import type { Change } from "../run/variants";
import type { Action } from "./action";

const isIdle = ({ phase }: StudioState): boolean => phase === "idle";
const isFitting = ({ phase }: StudioState): boolean => phase === "running" || phase === "paused";
const isUnderWay = ({ phase }: StudioState): boolean => phase !== "idle" && phase !== "finishing";

export const run: Action = { id: "run", part: "run", label: msg("Run"), keys: ["Space"], help: msg("Run, pause or go on"), can: isIdle, act: ({ runs }) => runs.run() };

export const pause: Action = { id: "pause", part: "run", label: msg("Pause"), says: ({ phase }) => (phase === "paused" ? msg("Go on") : msg("Pause")), keys: ["Space"], can: isFitting, act: ({ runs }) => runs.pause() };

export const step: Action = { id: "step", part: "run", label: msg("Step"), can: isFitting, act: ({ runs }) => runs.step() };

/** Keeps the best wire so far. */
export const stop: Action = { id: "stop", part: "run", label: msg("Stop"), can: isUnderWay, act: ({ runs }) => runs.stop() };

/** Throws the run away; the wire before it is back. */
export const reset: Action = { id: "reset", part: "run", label: msg("Reset"), can: isUnderWay, act: ({ runs }) => runs.cancel() };

/** Lays loose strokes beside the wire on the stage. */
export const compare: Action = { id: "compare", part: "run", label: msg("Compare with loose strokes"), can: isIdle, act: ({ runs }) => runs.compare() };

/** Shows an earlier wire of a run, by its index; null is the newest. */
export const lookAt: Action<[index: number | null]> = { id: "look-at", part: "timeline", label: msg("Look back"), act: ({ runs }, index) => runs.lookAt(index) };

export const continueFrom: Action<[index: number]> = {
  id: "continue-from",
  part: "timeline",
  label: msg("Go on from here"),
  // One run at a time: what was made here waits for one of another task.
  can: ({ running, doc }) => running === null || running === doc.task,
  act: ({ runs }, index) => runs.continueFrom(index),
};

export const continueUnfinished: Action = { id: "continue-unfinished", label: msg("Go on"), can: isIdle, act: ({ runs }) => runs.continueUnfinished() };

export const dropUnfinished: Action = { id: "drop-unfinished", label: msg("Leave it"), can: isIdle, act: ({ runs }) => runs.dropUnfinished() };

export const undo: Action = {
  id: "undo",
  part: "undo",
  label: msg("Undo"),
  says: ({ undo }) => (undo ? msg(str`Undo: ${undo}`) : msg("Undo")),
  keys: ["Z", "Ctrl Z"],
  help: msg("Undo"),
  everywhere: true,
  can: (state) => isIdle(state) && state.undo !== null,
  act: ({ project }) => project.undo(),
};

export const redo: Action = {
  id: "redo",
  part: "undo",
  label: msg("Redo"),
  says: ({ redo }) => (redo ? msg(str`Redo: ${redo}`) : msg("Redo")),
  keys: ["Shift Z", "Ctrl Y"],
  help: msg("Redo"),
  everywhere: true,
  can: (state) => isIdle(state) && state.redo !== null,
  act: ({ project }) => project.redo(),
};

export const chooseTask: Action<[task: string]> = { id: "choose-task", part: "tabs", label: msg("What to make"), act: ({ opener }, task) => opener.turnTo(task) };

/** This tab keeps the project from now on. */
export const keepHere: Action = { id: "keep-here", label: msg("Keep it here instead"), act: ({ project }) => project.keepHere() };

/** Not while anything is under way: the page starts anew with it. */
export const loadNew: Action = { id: "load-new", label: msg("Load it"), can: (state) => isIdle(state) && state.loadNew !== null, act: ({ bench: { store } }) => store.get().loadNew?.() };

/** Closes what the person has read: a notice, or the problem. */
export const dismiss: Action<[notice: string]> = {
  id: "dismiss",
  label: msg("Close this message"),
  act: ({ bench: { store } }, notice) => {
    const { problem, notices } = store.get();
    store.set({ problem: problem === notice ? "" : problem, notices: notices.filter((other) => other !== notice) });
  },
};

export const setWhenHidden: Action<[choice: WhenHidden]> = {
  id: "when-hidden",
  label: msg("When this tab is hidden"),
  act: ({ bench: { store } }, choice) => {
    remember("hidden", choice);
    store.set({ whenHidden: choice });
  },
};

/** Lays a wire of the same run but for one thing beside the wire on the stage. */
export const compareWith: Action<[change: Change]> = { id: "compare-with", label: msg("Lay it beside"), can: isIdle, act: ({ runs }, change) => runs.compare(change) };

export const useTool: Action<[tool: Tool | null]> = { id: "use-tool", label: msg("Tool"), act: ({ bench: { store } }, tool) => tool !== null && isLocked(store.get(), tool) ? undefined : store.set({ tool }) };
