/** One value, and whoever wants to know when it changes. */

export class Store<T extends object> {
  private readonly listeners = new Set<(value: Readonly<T>) => void>();

  constructor(private value: Readonly<T>) {}

  get(): Readonly<T> {
    return this.value;
  }

  set(change: Partial<T>): void {
    this.value = { ...this.value, ...change };
    for (const listener of this.listeners) listener(this.value);
  }

  /** Calls now and after every change; the result ends it. */
  follow(listener: (value: Readonly<T>) => void): () => void {
    this.listeners.add(listener);
    listener(this.value);
    return () => this.listeners.delete(listener);
  }
}
