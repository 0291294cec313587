/** One value, and whoever wants to know when it changes. What follows from the rest is worked out anew with every change. */

export class Store<Base extends object, Value extends Base = Base> {
  private readonly listeners = new Set<(value: Readonly<Value>) => void>();
  private value: Readonly<Value>;
  /** Whether changes are told later, in one. */
  private batching = false;

  constructor(
    private base: Readonly<Base>,
    private readonly derived: (base: Readonly<Base>) => Value = (base) => base as Readonly<Value>,
  ) {
    this.value = derived(base);
  }

  get(): Readonly<Value> {
    return this.value;
  }

  set(change: Partial<Base>): void {
    this.base = { ...this.base, ...change };
    this.value = this.derived(this.base);
    if (this.batching) return;
    for (const listener of this.listeners) listener(this.value);
  }

  /** Tells what changes meanwhile as one change. */
  batch(changes: () => void): void {
    if (this.batching) return changes();
    this.batching = true;
    try {
      changes();
    } finally {
      this.batching = false;
      this.set({});
    }
  }

  /** Calls now and after every change; the result ends it. */
  follow(listener: (value: Readonly<Value>) => void): () => void {
    this.listeners.add(listener);
    listener(this.value);
    return () => this.listeners.delete(listener);
  }

  /** Calls whenever one of what `pick` takes is another than before; the result ends it. */
  watch(pick: (value: Readonly<Value>) => readonly unknown[], listener: (value: Readonly<Value>) => void): () => void {
    let before = pick(this.value);
    return this.follow((value) => {
      const now = pick(value);
      const same = now.every((part, i) => part === before[i]);
      before = now;
      if (!same) listener(value);
    });
  }
}
