import { msg, str } from "@lit/localize";
import { css, html, nothing, type TemplateResult } from "lit";
import { customElement, property } from "lit/decorators.js";
import { continueUnfinished, dismiss, dropUnfinished, keepHere, loadNew } from "../../state/actions/actions";
import type { Studio, StudioState } from "../../state/studio";
import { count } from "../../words/numbers";
import { Part } from "../../view/part";
import { engineProblem } from "./engine-check";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";

/** What a person should know and can do something about: calm, over the stage, so that nothing moves; and problems. */
@customElement("notice-list")
export class NoticeList extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  private readonly engineProblem = engineProblem();

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: 8px;
        pointer-events: none;
      }
      .notice {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 8px;
        padding: 8px 8px 8px 16px;
        padding-inline: 16px 8px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
        box-shadow: var(--shadow);
        pointer-events: auto;
      }
      .notice > span {
        flex: 1 1 200px;
        min-width: 0;
        overflow-wrap: anywhere;
      }
      .problem {
        flex-wrap: nowrap;
        border-color: var(--error);
        color: var(--error);
      }
      .problem > span {
        flex-basis: 0;
      }
      button {
        min-height: 36px;
      }
      @media (pointer: coarse) {
        button {
          min-height: 44px;
        }
      }
    `,
  ];

  override render() {
    const { keeping, unfinished, problem, notices, phase, lesson } = this.state;
    return html`
      <div role="alert">
        ${problem
          ? html`<div class="notice problem">
              ${icons.warning}<span>${problem}</span>
              <button class="plain square" aria-label=${msg("Close this message")} @click=${() => this.studio.act(dismiss, problem)}>${icons.close}</button>
            </div>`
          : nothing}
      </div>
      ${notices.map((words) =>
        this.notice(
          words,
          html`<button class="plain square" aria-label=${msg("Close this message")} @click=${() => this.studio.act(dismiss, words)}>${icons.close}</button>`,
        ),
      )}
      ${this.engineProblem ? this.notice(this.engineProblem) : nothing}
      ${unfinished && phase === "idle" && !lesson
        ? this.notice(
            unfinished.iterations > 0
              ? msg(str`A run was cut off at step ${count(unfinished.iteration)} of ${count(unfinished.iterations)}.`)
              : msg("A run was cut off before its first wire."),
            html`<button class="primary" @click=${() => this.studio.act(continueUnfinished)}>${continueUnfinished.label}</button>
              <button @click=${() => this.studio.act(dropUnfinished)}>${dropUnfinished.label}</button>`,
          )
        : nothing}
      ${this.state.loadNew && phase === "idle" && !lesson
        ? this.notice(msg("A new version of this page is ready."), html`<button @click=${() => this.studio.act(loadNew)}>${loadNew.label}</button>`)
        : nothing}
      ${keeping === "elsewhere" && !lesson
        ? this.notice(
            msg("This project is open in another tab; what you do here is not kept."),
            html`<button @click=${() => this.studio.act(keepHere)}>${keepHere.label}</button>`,
          )
        : nothing}
    `;
  }

  private notice(words: string, buttons?: TemplateResult): TemplateResult {
    return html`<div class="notice" role="status"><span>${words}</span>${buttons ?? nothing}</div>`;
  }
}
