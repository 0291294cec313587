/** The names of what was given for a wire. */

import { deskOf, type StudioState } from "../../state/studio";
import type { PageTask } from "../shared/page-task";

export function labelsOf({ doc }: StudioState, task: PageTask): readonly string[] {
  const { made } = deskOf(doc);
  const given = made?.track?.given ?? (made?.source === "example" ? doc.given[doc.task] : task.blank);
  return task.labels(given).filter(Boolean);
}
