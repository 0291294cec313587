/**
 * A lesson as its file says it. Its texts stand beside it by language, under keys that follow from it (`textKeys`), so that
 * one file of steps does for all languages.
 */

import { msg, str } from "@lit/localize";
import { Fault, fields, list, name, number, oneOf, pairs, text, yes, type Reader } from "./reading";

export const LESSON_VERSION = 1;

/** What a step is for; `try` is hands-on, `make` a wire of one's own, `wall` shows what the class made. */
export const KINDS = ["read", "predict", "try", "run", "explain", "make", "wall"] as const;
export type Kind = (typeof KINDS)[number];

const names = list(name);

/** What lies on the page as the step begins; what people make of it stays until a step opens something else. */
const opening = fields({}, {
  /** The job's example, with its wire. */
  example: yes,
  /** Nothing at all. */
  blank: yes,
  /** Files of the gallery's folders or the lesson's own, as if somebody dropped them. */
  files: list(text, 1),
  /** What the job's address can name. */
  given: pairs(text),
});

const question = fields({ choices: list(name, 2), right: name }, {});
const table = fields({ columns: list(name, 1), rows: list(fields({ id: name, values: list(number, 1) }, {}), 1) }, {});

const step = fields({ id: name, kind: oneOf(KINDS) }, {
  open: opening,
  settings: pairs(text),
  /** From where the stage looks, and which tool lies open. */
  view: oneOf(["room", "front", "side", "top"]),
  tool: oneOf(["glass", "hands"]),
  question,
  /** Measured figures. */
  table,
  /** Whether there is something to look at while it goes on. */
  watch: yes,
  lock: names,
  hide: names,
});

/** Of the printed sheet: a question with lines to write on, or with squares to draw in. */
const item = fields({ id: name }, { lines: number, squares: number });

const lesson = fields({ version: number, id: name, job: name, minutes: number, steps: list(step, 1), sheet: list(item, 1) }, { lock: names, hide: names });

type Of<R> = R extends Reader<infer T> ? T : never;
export type Lesson = Of<typeof lesson>;
export type Step = Of<typeof step>;
export type Opening = Of<typeof opening>;
export type Table = Of<typeof table>;
export type Texts = Readonly<Record<string, string>>;

/** Throws a `Fault` that says what is wrong with it. */
export function readLesson(value: unknown): Lesson {
  const version = (value as { readonly version?: unknown } | null)?.version;
  if (typeof version === "number" && version > LESSON_VERSION) throw new Fault(msg("This lesson was made for a newer Wire4D. Reload the page to get it, then open the lesson again."));
  const read = lesson(value, "lesson");
  const ids = read.steps.map(({ id }) => id);
  const twice = ids.find((id, i) => ids.indexOf(id) !== i);
  if (twice !== undefined) throw new Fault(msg(str`Two steps of this lesson are called “${twice}”.`));
  for (const { id, question, table } of read.steps) {
    if (question && !question.choices.includes(question.right)) throw new Fault(msg(str`The right answer of step “${id}” is not among its choices.`));
    if (table?.rows.some(({ values }) => values.length !== table.columns.length)) throw new Fault(msg(str`The table of step “${id}” has rows of other lengths than its heading.`));
  }
  return read;
}

/** All keys of its texts. */
export function textKeys({ steps, sheet }: Lesson): readonly string[] {
  const ofStep = ({ id, question, table, watch }: Step): readonly string[] => [
    `${id}.title`,
    `${id}.text`,
    ...(watch ? [`${id}.watch`] : []),
    ...(question ? [`${id}.question`, ...question.choices.flatMap((choice) => [`${id}.choice.${choice}`, `${id}.says.${choice}`])] : []),
    ...(table ? [`${id}.table`, ...table.columns.map((column) => `${id}.column.${column}`), ...table.rows.map((row) => `${id}.row.${row.id}`)] : []),
  ];
  return ["title", "about", "teacher.aim", "teacher.how", "teacher.answers", ...steps.flatMap(ofStep), ...sheet.map(({ id }) => `sheet.${id}`)];
}

/** The step whose opening counts at a step: the last one up to it that opens something. */
export function openedAt({ steps }: Lesson, at: number): number {
  return Math.max(0, steps.findLastIndex(({ open }, i) => open !== undefined && i <= at));
}

/** A lesson that somebody is in. */
export interface LessonState {
  readonly lesson: Lesson;
  readonly texts: Texts;
  /** The step's index. */
  readonly at: number;
  /** What was answered, by the step's id. */
  readonly answers: Readonly<Record<string, string>>;
  /** For a stand that many pass by. */
  readonly kiosk: boolean;
}

export const stepOf = ({ lesson, at }: Pick<LessonState, "lesson" | "at">): Step => lesson.steps[at]!;
