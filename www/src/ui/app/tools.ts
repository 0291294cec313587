/** Where the tools are that lie open beside the stage: each comes when it is first opened. */

import type { Tool } from "../../state/contract/state";
import type { OpenTool } from "../stage/tool";

export const TOOL_PARTS: Readonly<Partial<Record<Tool, () => Promise<{ readonly open: OpenTool }>>>> = {
  glass: () => import("../glass/open"),
  hands: () => import("../hands/open"),
};
