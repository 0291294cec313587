/** What survives a reload: the project in the browser's own database, and which tab may write to it. */

import { openDB, type DBSchema, type IDBPDatabase, type IDBPTransaction } from "idb";
import type { Snapshot } from "../../engine/protocol";
import { deskOf, EMPTY_DESK, type Desk, type Doc } from "./document";
import type { Track } from "./track";

/** A run under way; what it has come to so far lies in the snapshots. */
export type KeptRun = Omit<Track, "snapshots">;

/** The document in parts, so that a stroke writes its own sheet and nothing else: `task`, `desk/NAME`, `given/NAME/…`. */
export type Parts = Readonly<Record<string, unknown>>;

/** How what is given for a task is kept. */
export interface Form<Given> {
  /** What changes by itself is a part of its own. Parts that are alike must be the same. */
  parts(given: Given): Parts;
  /** What was given, from such parts; from none, nothing. */
  whole(parts: Parts): Given;
}

/** How things are kept, by task; and, from how they were kept before, as they are kept now. */
export interface Forms {
  readonly byTask: Readonly<Record<string, Form<unknown>>>;
  before(parts: Parts): Parts;
  runBefore(run: object): KeptRun;
}

interface Schema extends DBSchema {
  document: { key: string; value: unknown };
  run: { key: "now"; value: KeptRun };
  /** Of the run under way, by iteration. */
  snapshots: { key: number; value: Snapshot };
}

/** All of them, also of what is empty: it may not have been when it was written last. */
export function partsOf(doc: Doc, forms: Forms["byTask"]): Parts {
  const parts: Record<string, unknown> = { task: doc.task };
  for (const [name, form] of Object.entries(forms)) {
    parts[`desk/${name}`] = deskOf(doc, name);
    for (const [part, value] of Object.entries(form.parts(doc.given[name]))) parts[`given/${name}/${part}`] = value;
  }
  return parts;
}

/** Null where nothing was ever kept. */
export function docOf(parts: Parts, forms: Forms["byTask"]): Doc | null {
  const { task } = parts;
  if (typeof task !== "string" || !(task in forms)) return null;
  const given: Record<string, unknown> = {};
  const desks: Record<string, Desk> = {};
  for (const [name, form] of Object.entries(forms)) {
    const prefix = `given/${name}/`;
    const own = Object.entries(parts).filter(([key]) => key.startsWith(prefix));
    given[name] = form.whole(Object.fromEntries(own.map(([key, value]) => [key.slice(prefix.length), value])));
    const desk = parts[`desk/${name}`] as Desk | undefined;
    if (desk) desks[name] = { ...EMPTY_DESK, ...desk };
  }
  return { task, given, desks };
}

const NAME = "wire4d";
/** In the first, tasks had no names of their own in it. */
const VERSION = 2;

export interface Kept {
  readonly doc: Doc | null;
  /** A run that came to no end. */
  readonly run: Track | null;
}

export class Keep {
  /** Writes come one after the other. */
  private queue: Promise<unknown> = Promise.resolve();
  private saved: Parts = {};

  private constructor(
    private readonly db: IDBPDatabase<Schema>,
    private readonly forms: Forms,
    private readonly onTrouble: () => void,
  ) {}

  /** Null where the browser keeps nothing. `onTrouble` hears of a write that failed: a full disk, storage cleared away. */
  static async open(forms: Forms, onTrouble: () => void): Promise<Keep | null> {
    try {
      const db = await openDB<Schema>(NAME, VERSION, {
        upgrade(db, version, _wanted, transaction) {
          if (version > 0) {
            renew(transaction, forms).catch(() => transaction.abort());
            return;
          }
          db.createObjectStore("document");
          db.createObjectStore("run");
          db.createObjectStore("snapshots", { keyPath: "iteration" });
        },
        // Another tab wants a newer database: let it.
        blocking: (_current, _wanted, event) => (event.target as IDBDatabase).close(),
        terminated: onTrouble,
      });
      return new Keep(db, forms, onTrouble);
    } catch {
      return null;
    }
  }

  async load(): Promise<Kept> {
    const { db } = this;
    const [names, values, run, snapshots] = await Promise.all([
      db.getAllKeys("document"),
      db.getAll("document"),
      db.get("run", "now"),
      db.getAll("snapshots"),
    ]);
    this.saved = Object.fromEntries(names.map((name, i) => [name, values[i]]));
    return { doc: docOf(this.saved, this.forms.byTask), run: run ? { ...run, snapshots } : null };
  }

  saveDoc(doc: Doc): Promise<void> {
    return this.write(async (db) => {
      const parts = partsOf(doc, this.forms.byTask);
      const changed = Object.keys(parts).filter((part) => parts[part] !== this.saved[part]);
      if (changed.length === 0) return;
      const transaction = db.transaction("document", "readwrite");
      await Promise.all([...changed.map((part) => transaction.store.put(parts[part], part)), transaction.done]);
      this.saved = parts;
    });
  }

  /** A run begins, at a snapshot of an earlier one or afresh. */
  beginRun({ snapshots, ...run }: Track): Promise<void> {
    return this.write(async (db) => {
      const transaction = db.transaction(["run", "snapshots"], "readwrite");
      const kept = transaction.objectStore("snapshots");
      await kept.clear();
      await Promise.all([
        transaction.objectStore("run").put(run, "now"),
        ...snapshots.map((snapshot) => kept.put(snapshot)),
        transaction.done,
      ]);
    });
  }

  addSnapshot(snapshot: Snapshot): Promise<void> {
    return this.write((db) => db.put("snapshots", snapshot));
  }

  /** The run has ended, or nobody wants it. */
  endRun(): Promise<void> {
    return this.write(async (db) => {
      const transaction = db.transaction(["run", "snapshots"], "readwrite");
      await Promise.all([transaction.objectStore("run").clear(), transaction.objectStore("snapshots").clear(), transaction.done]);
    });
  }

  private write(action: (db: IDBPDatabase<Schema>) => Promise<unknown>): Promise<void> {
    const done = this.queue.then(() => action(this.db)).then(
      () => undefined,
      (error: unknown) => {
        console.warn("keeping the project failed:", error);
        this.onTrouble();
      },
    );
    this.queue = done;
    return done;
  }
}

/** Writes what was kept before as it is kept now. */
async function renew(transaction: IDBPTransaction<Schema, ("document" | "run" | "snapshots")[], "versionchange">, forms: Forms): Promise<void> {
  const [document, run] = [transaction.objectStore("document"), transaction.objectStore("run")];
  const [names, values, kept] = await Promise.all([document.getAllKeys(), document.getAll(), run.get("now")]);
  const parts = forms.before(Object.fromEntries(names.map((name, i) => [name, values[i]])));
  await document.clear();
  await Promise.all(Object.entries(parts).map(([name, part]) => document.put(part, name)));
  if (kept) await run.put(forms.runBefore(kept), "now");
}

/**
 * One tab at a time writes the project. Calls `onChange` with whether this tab is it: now, and when another takes over.
 * The result makes this tab the one. Where the browser has no locks, every tab writes.
 */
export function tenancy(onChange: (here: boolean) => void): () => void {
  const locks = navigator.locks as LockManager | undefined;
  if (!locks) {
    onChange(true);
    return () => undefined;
  }
  const request = (options: LockOptions): void => {
    locks
      .request("wire4d-project", options, (lock) => {
        onChange(lock !== null);
        // Held until the tab closes or another steals it.
        return lock ? new Promise<void>(() => undefined) : undefined;
      })
      .catch(() => onChange(false));
  };
  request({ ifAvailable: true });
  return () => request({ steal: true });
}
