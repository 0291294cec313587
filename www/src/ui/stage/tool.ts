/** What a tool lays on the page while it is open beside the stage. */

import type { TemplateResult } from "lit";
import type { Studio, StudioState } from "../../state/studio";
import type { WireStage } from "./wire-stage";

export interface ToolParts {
  /** In place of the left column on a desk, in the sheet on a phone: `narrow`. */
  panel(state: StudioState, narrow: boolean): TemplateResult;
  /** Under the timeline of a desk. */
  under?(state: StudioState): TemplateResult;
}

/** Called once, when it is first opened. */
export type OpenTool = (studio: Studio, stage: WireStage) => ToolParts;
