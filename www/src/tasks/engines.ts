/** Each task's end of the worker: `engine/engine.ts` in its folder. */

import type { TaskEngine } from "../engine/task-engine";

const found = import.meta.glob<{ readonly engine: TaskEngine }>("./*/engine/engine.ts", { eager: true });

export const ENGINES: readonly TaskEngine[] = Object.values(found).map(({ engine }) => engine);
