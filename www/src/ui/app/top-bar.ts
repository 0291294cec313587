import { css, html } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { deskOf, type Studio, type StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import { jobTabs, jobTabsStyle } from "./task-tabs";
import { chooseTheme, nextTheme, theme, type Theme } from "../shared/theme";

const THEME_WORDS: Readonly<Record<Theme, string>> = { system: "as the system", light: "light", dark: "dark" };

/** Name, what to make, undo, redo, sharing, colours and help. Fires `share` and `help`. */
@customElement("top-bar")
export class TopBar extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @state() private theme = theme();

  static override styles = [
    controls,
    jobTabsStyle,
    css`
      :host {
        display: flex;
        align-items: center;
        gap: 16px;
        min-width: 0;
        padding: 0 16px 0 24px;
        padding-inline: 24px 16px;
      }
      h1 {
        margin: 0;
        font-size: 20px;
        font-weight: 600;
        letter-spacing: -0.01em;
      }
      h1 b {
        font-weight: 600;
        color: var(--copper-text);
      }
      .tools {
        display: flex;
        align-items: center;
        gap: 4px;
      }
      .share {
        margin-inline: 8px;
      }
      @media (max-width: 819px), (max-width: 1099px) and (orientation: portrait) {
        :host {
          padding-inline: 16px 4px;
        }
        .tools {
          gap: 0;
        }
        .share {
          display: none;
        }
      }
      /* Where there is room for one of them, it is the tabs. */
      @media (max-width: 559px) {
        :host {
          gap: 0;
          padding-inline-start: 6px;
        }
        h1 {
          position: absolute;
          clip-path: inset(50%);
        }
      }
    `,
  ];

  override render() {
    const { undo, redo, phase, running, doc } = this.state;
    const idle = phase === "idle";
    const colours = `Colours: ${THEME_WORDS[this.theme]}. Switch to ${THEME_WORDS[nextTheme(this.theme)]}`;
    return html`
      <h1>Wire<b>4D</b></h1>
      ${jobTabs(doc.job, running, (job) => this.studio.choose(job))}
      <div class="tools">
        ${this.tool(icons.undo, undo ? `Undo: ${undo}` : "Undo", idle && undo !== null, () => this.studio.undo())}
        ${this.tool(icons.redo, redo ? `Redo: ${redo}` : "Redo", idle && redo !== null, () => this.studio.redo())}
        <button class="share" ?disabled=${!deskOf(doc).made || !idle} @click=${() => this.dispatchEvent(new Event("share"))}>${icons.share} Share</button>
        ${this.tool(icons[this.theme], colours, true, () => chooseTheme((this.theme = nextTheme(this.theme))))}
        ${this.tool(icons.help, "Help", true, () => this.dispatchEvent(new Event("help")))}
      </div>
    `;
  }

  private tool(icon: unknown, words: string, enabled: boolean, act: () => void) {
    return html`<button class="plain square" aria-label=${words} title=${words} ?disabled=${!enabled} @click=${act}>${icon}</button>`;
  }
}
