/** Undo and redo over immutable values: every step keeps the whole value before it, which shares what did not change. */

/** Steps that can be taken back; older ones are forgotten. */
const MOST_STEPS = 200;
/** Changes of one kind that follow each other this closely are one step: a slider that is dragged. */
const TOGETHER_MS = 800;

interface Step<T> {
  readonly label: string;
  /** The value on the other side of the step. */
  readonly value: T;
}

export class Edits<T> {
  private past: Step<T>[] = [];
  private future: Step<T>[] = [];
  private last: { readonly kind: string; readonly atMs: number } | null = null;

  constructor(private value: T) {}

  get present(): T {
    return this.value;
  }

  /** What undo would take back, in words. */
  get undoes(): string | null {
    return this.past.at(-1)?.label ?? null;
  }

  get redoes(): string | null {
    return this.future.at(-1)?.label ?? null;
  }

  /** A step with what a person would call it. Steps of one non-empty `kind` in close succession become one. */
  apply(label: string, value: T, kind = "", nowMs = performance.now()): void {
    const joins = kind !== "" && this.last?.kind === kind && nowMs - this.last.atMs < TOGETHER_MS && this.past.length > 0;
    if (!joins) this.past = [...this.past, { label, value: this.value }].slice(-MOST_STEPS);
    this.last = { kind, atMs: nowMs };
    this.future = [];
    this.value = value;
  }

  /** Another value in place of the present one, and no step: for what nobody did. */
  replace(value: T): void {
    this.value = value;
  }

  /** What nobody did, in every step: no undo takes it away. */
  amend(how: (value: T) => T): void {
    const amended = (step: Step<T>): Step<T> => ({ ...step, value: how(step.value) });
    this.value = how(this.value);
    this.past = this.past.map(amended);
    this.future = this.future.map(amended);
  }

  undo(): T {
    [this.past, this.future] = this.moved(this.past, this.future);
    return this.value;
  }

  redo(): T {
    [this.future, this.past] = this.moved(this.future, this.past);
    return this.value;
  }

  private moved(from: Step<T>[], to: Step<T>[]): [Step<T>[], Step<T>[]] {
    const step = from.at(-1);
    if (!step) return [from, to];
    const there = { label: step.label, value: this.value };
    this.value = step.value;
    this.last = null;
    return [from.slice(0, -1), [...to, there]];
  }
}
