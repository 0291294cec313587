import { msg, str } from "@lit/localize";
import { html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { isHidden } from "../../state/common/locks";
import { chooseTask, redo, undo } from "../../state/actions/actions";
import type { Studio, StudioState } from "../../state/studio";
import { Part } from "../../view/part";
import { icons } from "../shared/icons";
import type { PageTask } from "../shared/page-task";
import { controls } from "../shared/shared";
import { help, share, type PageAction } from "./actions";
import { taskTabs, taskTabsStyle } from "./task-tabs";
import { chooseTheme, nextTheme, theme, type Theme } from "../shared/theme";
import { topBarStyle } from "./top-bar-style";

const THEME_WORDS: Readonly<Record<Theme, string>> = { system: msg("as the system"), light: msg("light"), dark: msg("dark") };

/** Name, what to make, undo, redo, sharing, colours and help. */
@customElement("top-bar")
export class TopBar extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @property({ attribute: false }) tasks!: readonly PageTask[];
  /** Does what is the page's to do. */
  @property({ attribute: false }) act!: (action: PageAction) => void;
  @state() private theme = theme();

  static override styles = [controls, taskTabsStyle, topBarStyle];

  override render() {
    const { running, doc } = this.state;
    const colours = msg(str`Colours: ${THEME_WORDS[this.theme]}. Switch to ${THEME_WORDS[nextTheme(this.theme)]}`);
    return html`
      <h1>Wire<b>4D</b></h1>
      ${isHidden(this.state, "tabs")
        ? html`<span class="tasks"></span>`
        : taskTabs(this.tasks, doc.task, running, (task) => this.studio.act(chooseTask, task))}
      ${isHidden(this.state, "gallery") ? nothing : html`<a class="gallery" href="./gallery.html">${msg("Gallery")}</a> <a class="gallery lessons" href="./teachers.html">${msg("Lessons")}</a>`}
      <div class="tools">
        ${this.acting(undo, icons.undo)} ${this.acting(redo, icons.redo)}
        <button class="share" ?hidden=${isHidden(this.state, "share")} ?disabled=${!this.studio.can(share)} @click=${() => this.act(share)}>${icons.share} ${msg("Share")}</button>
        ${this.tool(icons[this.theme], colours, true, () => chooseTheme((this.theme = nextTheme(this.theme))))}
        ${this.acting(help, icons.help)}
      </div>
    `;
  }

  private acting(action: PageAction, icon: unknown) {
    return this.tool(icon, action.says?.(this.state) ?? action.label, this.studio.can(action), () => this.act(action));
  }

  private tool(icon: unknown, words: string, enabled: boolean, act: () => void) {
    return html`<button class="plain square" aria-label=${words} title=${words} ?disabled=${!enabled} @click=${act}>${icon}</button>`;
  }
}
