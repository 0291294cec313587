/** The gallery's works as `gallery/works.json` has them. */

import kinds from "../../gallery/kinds.json";

/** What visitors call the tasks: as the app's tabs do. */
export const KINDS: Readonly<Record<string, string>> = kinds;

export interface Work {
  /** Of its files, and in addresses. */
  readonly name: string;
  readonly task: string;
  readonly title: string;
  /** One sentence. */
  readonly sentence: string;
  /** What `wire4d` made it of: a task, files of `gallery/inputs` or names of shapes, and options. */
  readonly make: readonly string[];
}

/** Pictures that it was made of; a person's own, not the names of built-in shapes. */
export const picturesOf = ({ make }: Work): readonly string[] => make.filter((word) => word.endsWith(".png"));

/** A mesh from a file. */
export const meshOf = ({ make }: Work): string | null => make.find((word) => word.endsWith(".obj")) ?? null;

/** A built-in shape and style, as a person reads them. */
export function namesOf(work: Work): readonly string[] {
  const { make } = work;
  if (picturesOf(work).length > 0) return [];
  const style = make.indexOf("--style");
  return [...(/\./.test(make[1]!) ? [] : [make[1]!]), ...(style < 0 ? [] : [make[style + 1]!])];
}

/** Where its file lies beside the page. */
export const fileOf = ({ name }: Work): string => `gallery/works/${name}.wire.json`;

/** The app, with the work and what it was made of; a mesh comes first, or the wire would have nothing to cover, and to its task. */
export function addressOf(work: Work): string {
  const mesh = meshOf(work);
  return `./#${mesh ? `job=${work.task}&open=gallery/inputs/${mesh}&` : ""}open=${fileOf(work)}`;
}
