import { LitElement } from "lit";
import { nextTurn } from "../state/common/next-turn";

/** A part of the page that is rendered in a task of its own: one change of everything never becomes one long task. */
export class Part extends LitElement {
  protected override async scheduleUpdate(): Promise<void> {
    await nextTurn();
    super.scheduleUpdate();
  }
}
