/** The lessons that come with the page, `www/lessons/ID/`: each file is fetched when it is wanted. */

import { msg, str } from "@lit/localize";
import { readLesson, type Lesson, type Texts } from "../lesson/lesson";
import { Fault } from "../lesson/reading";

type Load<T> = () => Promise<T>;

const LESSONS = import.meta.glob<unknown>("../../../lessons/*/lesson.json", { import: "default" });
const TEXTS = import.meta.glob<Texts>("../../../lessons/*/texts.*.json", { import: "default" });
const FILES = import.meta.glob<string>("../../../lessons/*/*.{png,wire.json}", { query: "?url", import: "default" });

/** In the order of a course; also those that have no place in it. */
const COURSE: readonly string[] = ["views", "spline", "pull", "one-wire", "impossible", "smooth", "cover"];

const at = (id: string, file: string): string => `../../../lessons/${id}/${file}`;
const found = <T>(shelf: Readonly<Record<string, Load<T>>>, id: string, file: string): Load<T> | undefined => (Object.hasOwn(shelf, at(id, file)) ? shelf[at(id, file)] : undefined);

export const lessonIds: readonly string[] = Object.keys(LESSONS)
  .map((path) => path.split("/").at(-2)!)
  .toSorted((a, b) => place(a) - place(b));

function place(id: string): number {
  return COURSE.indexOf(id) + 1 || COURSE.length + 1;
}

/** Throws a `Fault` where there is none, or it cannot be read. */
export async function lessonCalled(id: string): Promise<Lesson> {
  const load = found(LESSONS, id, "lesson.json");
  if (!load) throw new Fault(msg(str`There is no lesson “${id.slice(0, 40)}”. The page for teachers lists those that there are.`));
  return readLesson(await load());
}

/** In the language, or else in English. */
export async function textsOf(id: string, language: string): Promise<Texts> {
  const load = found(TEXTS, id, `texts.${language}.json`) ?? found(TEXTS, id, `texts.${language.split("-")[0]!}.json`) ?? found(TEXTS, id, "texts.en.json")!;
  return load();
}

/** A file of the lesson's own; null where it has none of that name. */
export async function addressOfFile(id: string, name: string): Promise<string | null> {
  return (await found(FILES, id, name)?.()) ?? null;
}
