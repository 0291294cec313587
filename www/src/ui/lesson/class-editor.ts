import { msg } from "@lit/localize";
import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { forOthers } from "../../state/address/renderer";
import { PARTS } from "../../state/common/locks";
import { writeAsked } from "../../state/lesson/asked";
import { tableOf, type Studio, type StudioState } from "../../state/studio";
import { lessonCalled, lessonIds, textsOf } from "../../state/teaching/shelf";
import { Part } from "../../view/part";
import { addressIn, LANGUAGES, type Language } from "../../words/languages";
import { copied } from "../save/copied";
import { wordsFor } from "../settings/setting-words";
import { foldStyle } from "../shared/fold";
import { icons } from "../shared/icons";
import { controls } from "../shared/shared";
import { partWords } from "./part-words";

type State = "shown" | "locked" | "hidden";
interface Listed {
  readonly id: string;
  readonly title: string;
  readonly job: string;
}

/** Makes a link for a class: a lesson or the page as it is set now, with what is locked and what is hidden. */
@customElement("class-editor")
export class ClassEditor extends Part {
  @property({ attribute: false }) studio!: Studio;
  @property({ attribute: false }) state!: StudioState;
  @state() private lessons: readonly Listed[] = [];
  @state() private lesson = "";
  @state() private kiosk = false;
  @state() private language: Language | "" = "";
  /** What is not simply shown, by name. */
  @state() private states: Readonly<Record<string, State>> = {};
  @query("#link") private field!: HTMLInputElement;

  static override styles = [
    controls,
    foldStyle,
    css`
      :host {
        display: grid;
        gap: 8px;
      }
      p {
        margin: 0;
      }
      label:not(.check) {
        display: grid;
        grid-template-columns: minmax(0, 1fr) 96px;
        align-items: center;
        gap: 8px;
        font-size: 13px;
      }
      label.lesson,
      label.link {
        grid-template-columns: minmax(0, 1fr);
        gap: 4px;
      }
      .check {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 32px;
        font-size: 13px;
      }
      input[type="text"],
      select {
        width: 100%;
      }
      .pair {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 8px;
      }
      .pair > * {
        font-size: 13px;
      }
      a {
        display: inline-flex;
        align-items: center;
        justify-content: center;
        gap: 8px;
        min-height: 40px;
        border: 1px solid var(--line);
        border-radius: 6px;
        background: var(--raised);
        color: inherit;
        text-decoration: none;
      }
      .group {
        gap: 4px;
      }
    `,
  ];

  override render() {
    const rows = tableOf(this.state)?.rows ?? [];
    const { link } = this;
    return html`
      <p class="small quiet">${msg("A link that opens the page as it is set now, with less to press. Nothing is stored anywhere but in the link.")}</p>
      <label class="lesson"
        >${msg("Lesson")}
        <select id="lesson" @change=${(event: Event) => (this.lesson = (event.target as HTMLSelectElement).value)}>
          <option value="">${msg("None: the page as it is")}</option>
          ${this.lessons.map(({ id, title }) => html`<option value=${id} .selected=${id === this.lesson}>${title}</option>`)}
        </select></label
      >
      ${this.lesson
        ? html`<label class="check"><input type="checkbox" .checked=${this.kiosk} @change=${(event: Event) => (this.kiosk = (event.target as HTMLInputElement).checked)} /> ${msg("For a stand: big buttons, begins anew when nobody is there")}</label>`
        : nothing}
      <label class="lesson"
        >${msg("Language")}
        <select id="language" @change=${(event: Event) => (this.language = (event.target as HTMLSelectElement).value as Language | "")}>
          <option value="">${msg("As each device has it")}</option>
          ${Object.entries(LANGUAGES).map(([code, name]) => html`<option value=${code} lang=${code} .selected=${code === this.language}>${name}</option>`)}
        </select></label
      >
      <details open>
        <summary>${msg("Parts of the page")} ${icons.more}</summary>
        <div class="group">${PARTS.map((part) => this.row(part, partWords(part)))}</div>
      </details>
      <details>
        <summary>${msg("Single settings")} ${icons.more}</summary>
        <div class="group">${rows.map(({ name }) => this.row(name, wordsFor(name).label))}</div>
      </details>
      <label class="link">${msg("The link")} <input id="link" type="text" readonly .value=${link} @focus=${() => this.field.select()} /></label>
      <div class="pair">
        <button @click=${this.copy}>${icons.link} ${msg("Copy link")}</button>
        <a href="./teachers.html#class=${encodeURIComponent(link)}" target="_blank" rel="noopener">${icons.file} ${msg("QR sheet")}</a>
      </div>
    `;
  }

  protected override firstUpdated(): void {
    void this.list();
  }

  private async list(): Promise<void> {
    this.lessons = await Promise.all(
      lessonIds.map(async (id) => {
        const [{ job }, { title = id }] = await Promise.all([lessonCalled(id), textsOf(id, document.documentElement.lang)]);
        return { id, title, job };
      }),
    );
  }

  private row(name: string, words: string) {
    const choices: Readonly<Record<State, string>> = { shown: msg("Shown"), locked: msg("Locked"), hidden: msg("Hidden") };
    const chosen = this.states[name] ?? "shown";
    return html`<label data-name=${name}
      >${words}
      <select @change=${(event: Event) => (this.states = { ...this.states, [name]: (event.target as HTMLSelectElement).value as State })}>
        ${Object.entries(choices).map(([state, words]) => html`<option value=${state} .selected=${state === chosen}>${words}</option>`)}
      </select></label
    >`;
  }

  private get link(): string {
    const { lesson, kiosk, states } = this;
    const names = (state: State): readonly string[] => Object.keys(states).filter((name) => states[name] === state);
    const listed = this.lessons.find(({ id }) => id === lesson);
    // A lesson brings settings of its own; those of another job are none of its business.
    const set = listed && listed.job !== this.state.doc.task ? "" : this.studio.saver.address("");
    return addressIn(forOthers(location.href), this.language || null) + writeAsked(set, { lesson: lesson || null, step: null, lock: names("locked"), hide: names("hidden"), kiosk: kiosk && lesson !== "" });
  }

  private readonly copy = async (): Promise<void> => {
    this.studio.say((await copied(this.link, this.field)) ? msg("Link copied. It is all that your class needs.") : msg("Copy the marked link with Ctrl or ⌘ and C"));
  };
}
