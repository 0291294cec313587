/** What people can ask for, in the order of the tabs; the first is what they see who have not chosen. */

import type { PageTask } from "../ui/shared/page-task";
import { fill } from "./fill/task";
import { multiview } from "./multiview/task";
import { stroke } from "./stroke/task";

export * as before from "./kept-before";

export const TASKS: readonly PageTask[] = [multiview, stroke, fill];
