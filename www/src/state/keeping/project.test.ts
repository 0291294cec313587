import { expect, it } from "vitest";
import type { Doc } from "./document";
import { Project, type ProjectState } from "./project";

const doc = (task: string): Doc => ({ task, given: {}, desks: {} });

it("puts the person's own aside, and brings it back with its steps", () => {
  let state = {} as ProjectState;
  const project = new Project(doc("own"), { byTask: {} } as never, (now) => (state = now));
  project.edit("Change it", { task: "changed" });
  project.setAside(doc("lesson"));
  expect(state).toMatchObject({ doc: doc("lesson"), undo: null, redo: null });
  project.edit("Draw", { task: "drawn" });
  expect(state.undo).toBe("Draw");
  // The next step of a lesson: no undo goes back into the one before, and the own stays what it was.
  project.setAside(doc("next"));
  project.undo();
  expect(state).toMatchObject({ doc: doc("next"), undo: null });
  project.bringBack();
  expect(state).toMatchObject({ doc: { ...doc("own"), task: "changed" }, undo: "Change it" });
  project.undo();
  expect(project.doc.given).toEqual({});
  expect(state.redo).toBe("Change it");
  project.bringBack();
  expect(state.redo).toBe("Change it");
});
