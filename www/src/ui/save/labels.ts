/** The names of what was given for a wire. */

import { deskOf, type StudioState } from "../../state/studio";
import type { PageTask } from "../shared/page-task";

/** In the order in which it was given, empty where something has none. */
export function givenLabels({ doc }: StudioState, task: PageTask): readonly string[] {
  const { made } = deskOf(doc);
  const given = made?.track?.given ?? (made?.source === "example" ? doc.given[doc.task] : task.blank);
  return task.labels(given);
}

export const labelsOf = (state: StudioState, task: PageTask): readonly string[] => givenLabels(state, task).filter(Boolean);
