/** Lessons: one is opened over the person's own project, which waits, and each step sets the page for itself. */

import { msg, str } from "@lit/localize";
import { remember, remembered } from "../common/remember";
import { joined, NO_LOCKS, PARTS, isLocked } from "../common/locks";
import { DURING_A_RUN, explain } from "../../words/sentences";
import { Problem } from "../../engine/client";
import type { SettingValues } from "../../engine/protocol";
import { readFragment } from "../address/fragment";
import type { Bench } from "../contract/bench";
import { firstState, whenIdle, type StudioStore } from "../contract/state";
import type { Task } from "../contract/task";
import { deskOf, withDesk, withGiven, type Doc } from "../keeping/document";
import { readAsked, writeAsked, type Asked } from "../lesson/asked";
import { openedAt, stepOf, type Lesson, type LessonState, type Opening } from "../lesson/lesson";
import { Fault } from "../lesson/reading";
import type { Opener } from "../opening/opener";
import type { Receiver } from "../opening/receiver";
import type { Runs } from "../run/runs";
import { addressOfFile, lessonCalled, textsOf } from "./shelf";

/** What lessons work with. */
export interface Classroom {
  readonly bench: Bench;
  readonly tasks: readonly Task[];
  readonly opener: Opener;
  readonly receiver: Receiver;
  readonly runs: Runs;
  /** A sentence that stays until it is closed. */
  notify(words: string): void;
  /** Puts a fragment into the address. */
  address(hash: string): void;
}

const NOTHING_ASKED: Asked = { lesson: null, step: null, kiosk: false, ...NO_LOCKS };
const STAYS = msg("This page is locked for a lesson. To leave it, ask your teacher.");

export class Lessons {
  private asked: Asked = NOTHING_ASKED;
  /** Of the address that brought the lesson. */
  private settings: SettingValues = {};
  /** What people made, by the step that opened it. */
  private docs = new Map<number, Doc>();
  /** The step that opened what lies on the page; -1 before any has. */
  private opened = -1;
  /** Steps are set one after the other, however quickly people turn to them. */
  private setting: Promise<void> = Promise.resolve();

  constructor(private readonly room: Classroom) {}

  /** Follows an address; false where it asks for no lesson, and what else it asks for is to be opened. */
  async open(hash: string): Promise<boolean> {
    const { bench, notify } = this.room;
    const asked = readAsked(hash);
    const { lesson } = bench.store.get();
    if (isLocked(bench.store.get(), "leave")) {
      if (lesson !== null && asked.lesson === lesson.lesson.id && asked.step !== null) this.go(this.indexOf(asked.step, lesson.lesson));
      else notify(STAYS);
      this.show();
      return true;
    }
    if (asked.lesson === null) {
      await this.leave();
      this.asked = asked;
      bench.store.set({ locks: joined(asked) });
      if (asked.kiosk) notify(msg("A stand needs a lesson: choose one in “For my class”. The page works as usual."));
      return false;
    }
    if (bench.busy && lesson === null) {
      bench.warn(DURING_A_RUN);
      return true;
    }
    try {
      const lesson = await lessonCalled(asked.lesson);
      await this.begin(lesson, asked, hash);
      return true;
    } catch (error) {
      bench.warn(error instanceof Fault ? error.message : explain(error, msg("The lesson")));
      return false;
    }
  }

  /** To a step, by its index. */
  go(at: number): void {
    const { store } = this.room.bench;
    const { lesson } = store.get();
    if (!lesson || !lesson.lesson.steps[at] || at === lesson.at) return;
    this.turn({ ...lesson, at });
  }

  /** Keeps an answer to the step's question. */
  answer(choice: string): void {
    const { store } = this.room.bench;
    const { lesson } = store.get();
    if (!lesson) return;
    const answers = { ...lesson.answers, [stepOf(lesson).id]: choice };
    this.put({ ...lesson, answers });
  }

  /** The step as it was at first: what was made in it is let go. */
  again(): void {
    const { lesson } = this.room.bench.store.get();
    if (!lesson) return;
    this.docs.delete(openedAt(lesson.lesson, lesson.at));
    this.opened = -1;
    this.turn(lesson);
  }

  /** The lesson from its beginning, without what the one before answered and made. */
  restart(): void {
    const { lesson } = this.room.bench.store.get();
    if (!lesson) return;
    this.docs.clear();
    this.opened = -1;
    this.turn({ ...lesson, at: 0, answers: {} });
  }

  /** The person's own project is back as it was. */
  async leave(): Promise<void> {
    const { bench, opener } = this.room;
    const { store, project } = bench;
    if (!store.get().lesson) return;
    this.asked = NOTHING_ASKED;
    await this.setting;
    await this.rest();
    store.batch(() => {
      store.set({ lesson: null, locks: NO_LOCKS, tool: null, ahead: null, lookingBack: null, problem: "", said: "" });
      project.bringBack();
    });
    this.show();
    await opener.example();
  }

  /** The address of a page that was set up for a class, in place of the project's own. */
  addressOver(hash: string): string {
    return writeAsked(hash, this.asked);
  }

  /** Says which names of the link nothing here answers to; once the core has told its settings. */
  check(): void {
    const { bench, notify } = this.room;
    const { tables, doc } = bench.store.get();
    if (!tables) return;
    const rows = (task: string): readonly string[] => (tables[task]?.rows ?? []).map(({ name }) => name);
    for (const name of new Set([...this.asked.lock, ...this.asked.hide])) {
      if (PARTS.some((part) => part === name) || rows(doc.task).includes(name)) continue;
      const elsewhere = Object.keys(tables).some((task) => rows(task).includes(name));
      notify(elsewhere ? msg(str`The link locks or hides “${name}”, which this job does not have. It changes nothing here.`) : msg(str`The link locks or hides “${name.slice(0, 40)}”, which is not known here. It was left out.`));
    }
  }

  private async begin(lesson: Lesson, asked: Asked, hash: string): Promise<void> {
    const { bench, tasks, notify } = this.room;
    const task = tasks.find(({ name }) => name === lesson.job);
    if (!task) throw new Fault(msg("This lesson is about something that this Wire4D cannot make. Reload the page to get a newer one."));
    const texts = await textsOf(lesson.id, document.documentElement.lang);
    const fragment = readFragment(hash, tasks);
    const { lesson: _lesson, step: _step, lock: _lock, hide: _hide, kiosk: _kiosk, ...settings } = fragment.settings;
    const otherJob = /[#&]job=/.test(hash) && fragment.task !== lesson.job;
    if (fragment.newer) notify(msg("This link was made by a newer Wire4D. Reload the page if something seems to be missing."));
    if (otherJob) notify(msg("The link asks for another job than its lesson is about. The lesson goes before, with its own settings."));
    if (fragment.code !== null) notify(msg("The link asks for a lesson and for a wire. The lesson is shown; open the wire by a link of its own."));
    await this.setting;
    this.asked = asked;
    this.settings = otherJob ? {} : settings;
    this.docs.clear();
    this.opened = -1;
    const kept = asked.kiosk ? null : keptOf(lesson);
    const at = asked.step === null ? (kept?.at ?? 0) : this.indexOf(asked.step, lesson);
    if (!bench.store.get().lesson) bench.project.setAside(this.blank(lesson));
    bench.store.set({ problem: "", said: "" });
    this.turn({ lesson, texts, at, answers: kept?.answers ?? {}, kiosk: asked.kiosk });
    this.check();
  }

  /** The index of a step as people count. */
  private indexOf(step: number, { steps }: Lesson): number {
    if (Number.isInteger(step) && step >= 1 && step <= steps.length) return step - 1;
    this.room.notify(msg(str`This lesson has ${steps.length} steps, and the link asks for another one. It begins with the first.`));
    return 0;
  }

  /** Its text is there at once; what it sets follows. */
  private turn(lesson: LessonState): void {
    const { store } = this.room.bench;
    const step = stepOf(lesson);
    store.batch(() => {
      this.put(lesson);
      store.set({ locks: joined(this.asked, lesson.lesson, step), tool: step.tool ?? null });
    });
    this.show();
    this.setting = this.setting.then(() => this.set()).catch((error: unknown) => this.room.bench.warn(explain(error, msg("This step"))));
  }

  private put(lesson: LessonState): void {
    this.room.bench.store.set({ lesson });
    if (!lesson.kiosk) remember(`lesson.${lesson.lesson.id}`, JSON.stringify({ at: lesson.at, answers: lesson.answers }));
  }

  /** Sets the page as the step that is looked at wants it; what was made before stays with its own steps. */
  private async set(): Promise<void> {
    const { bench } = this.room;
    const { store, project } = bench;
    const now = store.get().lesson;
    if (!now) return;
    await this.rest();
    const { lesson, at } = now;
    const opening = openedAt(lesson, at);
    // Whoever comes straight to a step finds what those before it would have set.
    let since = at;
    if (opening !== this.opened) {
      if (this.opened >= 0) this.docs.set(this.opened, bench.doc);
      this.opened = opening;
      const kept = this.docs.get(opening);
      store.batch(() => {
        store.set({ ahead: null, lookingBack: null });
        project.setAside(kept ?? this.blank(lesson));
      });
      if (!kept) {
        since = opening;
        await this.lay(lesson, lesson.steps[opening]!.open ?? {});
      }
    }
    const set = lesson.steps.slice(since, at + 1).map(({ settings }) => settings);
    const settings: SettingValues = Object.assign({}, deskOf(bench.doc, lesson.job).settings, ...set, this.settings);
    // Anew: no undo goes back into the step before.
    project.setAside({ ...bench.doc, ...withDesk(bench.doc, lesson.job, { settings }) });
  }

  private async lay({ id, job }: Lesson, { example, files, given }: Opening): Promise<void> {
    const { bench, tasks, opener, receiver } = this.room;
    if (example) await opener.example().then(() => arrived(bench.store));
    const named = given && tasks.find(({ name }) => name === job)?.address?.read(given);
    if (named) bench.project.replace(withGiven(bench.doc, job, named));
    if (files) await receiver.files(await Promise.all(files.map((file) => fetchedFile(id, file))));
  }

  /** A run of the step before is given up. */
  private async rest(): Promise<void> {
    const { bench, runs } = this.room;
    runs.cancel();
    await whenIdle(bench.store);
  }

  private blank({ job }: Lesson): Doc {
    return { ...firstState(this.room.tasks).doc, task: job };
  }

  /** The address leads back to where the lesson is. */
  private show(): void {
    const { lesson } = this.room.bench.store.get();
    const settings = new URLSearchParams(this.settings).toString();
    this.room.address(writeAsked(lesson ? settings : "", { ...this.asked, lesson: lesson?.lesson.id ?? null, step: lesson ? lesson.at + 1 : null }));
  }
}

/** Once a wire that is on its way has come: it is meant for this step, and for no other. */
function arrived(store: StudioStore): Promise<void> {
  return new Promise((resolve) => {
    const stop = store.follow(({ ahead }) => {
      if (ahead?.coming) return;
      queueMicrotask(() => stop());
      resolve();
    });
  });
}

interface Kept {
  readonly at: number;
  readonly answers: Readonly<Record<string, string>>;
}

/** Where this browser's last visitor of the lesson was; null where there was none, or what is kept is no longer understood. */
function keptOf({ id, steps }: Lesson): Kept | null {
  try {
    const { at, answers } = JSON.parse(remembered(`lesson.${id}`) ?? "null") as Kept;
    return steps[at] && typeof answers === "object" ? { at, answers } : null;
  } catch {
    return null;
  }
}

async function fetchedFile(id: string, name: string): Promise<File> {
  if (name.includes("/")) return (await (await import("../opening/beside")).filesBeside(`#open=${name}`))[0]!;
  const address = await addressOfFile(id, name);
  const response = address === null ? null : await fetch(address).catch(() => null);
  if (!response?.ok) throw new Problem(msg(str`A file of this lesson, ${name}, cannot be had. Check the connection, then start the step again.`));
  return new File([await response.blob()], name);
}
