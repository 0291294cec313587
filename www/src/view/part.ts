import { LitElement } from "lit";
import { nextTask } from "../state/next-task";

/** A part of the page that is rendered in a task of its own: one change of everything never becomes one long task. */
export class Part extends LitElement {
  protected override async scheduleUpdate(): Promise<void> {
    await nextTask();
    super.scheduleUpdate();
  }
}
