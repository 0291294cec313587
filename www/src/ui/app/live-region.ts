import { html, LitElement } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { Task } from "../../state/contract/task";
import type { StudioState } from "../../state/studio";
import { news, Pacer } from "./announce";
import { controls } from "../shared/shared";

/** Says politely what goes on. Seen by nobody. */
@customElement("live-region")
export class LiveRegion extends LitElement {
  tasks: readonly Task[] = [];
  /** Told of every state; only what changed is worth saying. */
  set state(now: StudioState) {
    if (this.last) this.pacer.add(news(this.last, now, this.tasks));
    this.last = now;
  }
  @state() private message = "";
  private last: StudioState | null = null;
  private readonly pacer = new Pacer((message) => (this.message = message));

  static override styles = controls;

  override render() {
    return html`<div class="unseen" role="status">${this.message}</div>`;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.pacer.stop();
  }
}
