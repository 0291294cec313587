/** What a wire is called after what was given for it. */

import { deskOf, type StudioState } from "../../state/studio";
import type { PageTask } from "../shared/page-task";

export function labelsOf({ doc }: StudioState, task: PageTask): readonly string[] {
  const { made } = deskOf(doc);
  const given = made?.track?.given ?? (made?.source === "example" ? doc.given[doc.task] : task.blank);
  return task.labels(given).filter(Boolean);
}

/** "Cat, Bird, and Fish", without the endings of files. */
export function titleOf(labels: readonly string[]): string {
  const words = labels.map((label) => label.replace(/\.\w{1,5}$/, "").trim()).filter(Boolean);
  return words.length ? new Intl.ListFormat("en", { type: "conjunction" }).format(words) : "A wire";
}

/** For people who do not see it. */
export const altOf = (labels: readonly string[]): string => (labels.length ? `One continuous wire that shows: ${titleOf(labels)}` : "A sculpture of one continuous wire");
