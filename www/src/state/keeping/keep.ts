/** What survives a reload: the project in the browser's own database, and which tab may write to it. */

import { openDB, type DBSchema, type IDBPDatabase } from "idb";
import type { Snapshot } from "../../engine/protocol";
import { EMPTY_DESK, type Doc, type Made } from "./document";
import type { Sheet, Track } from "./track";
import type { Cover } from "../../tasks/fill/given";

/** A run under way; what it has come to so far lies in the snapshots. */
export type KeptRun = Omit<Track, "snapshots">;

interface Schema extends DBSchema {
  /** The document in parts, so that a stroke writes its own sheet and nothing else. */
  document: { key: keyof Parts; value: Parts[keyof Parts] };
  run: { key: "now"; value: KeptRun };
  /** Of the run under way, by iteration. */
  snapshots: { key: number; value: Snapshot };
}

/**
 * `settings`, `made` and `loose` are the first job's: it had them before there was another. A shape may be large, and is
 * not written again with every style.
 */
type Parts = Doc["papers"] &
  Pick<Doc, "job" | "subject"> &
  Doc["desks"]["multiview"] &
  Omit<Doc["desks"], "multiview"> & { readonly solid: Cover["solid"] | null; readonly style: Cover["style"] };

function partsOf({ papers, job, subject, cover, desks: { multiview, ...desks } }: Doc): Parts {
  const { solid = null, style = null } = cover ?? {};
  return { ...papers, job, subject, solid, style, ...multiview, ...desks };
}

function docOf(parts: Partial<Parts>): Doc | null {
  const { front = null, side = null, top = null, job = "multiview", subject = null, settings, made = null, loose = null } = parts;
  const { solid = null, style = null, stroke = EMPTY_DESK, fill = EMPTY_DESK } = parts;
  if (!settings) return null;
  const desk = { settings, made: madeOf(made), loose: madeOf(loose) };
  return { job, papers: { front, side, top }, subject, cover: solid && { solid, style }, desks: { multiview: desk, stroke, fill } };
}

/** A run was about drawings before there was anything else for it to be about. */
type OldTrack = { readonly sheets: readonly Sheet[] };

export function trackOf<T extends Omit<Track, "given">>(kept: T & (Pick<Track, "given"> | OldTrack)): T & Pick<Track, "given"> {
  return "given" in kept ? kept : { ...kept, given: { job: "multiview", sheets: kept.sheets } };
}

const madeOf = (made: Made | null): Made | null => made && { ...made, track: made.track && trackOf(made.track) };

const NAME = "wire4d";
const VERSION = 1;

export interface Kept {
  readonly doc: Doc | null;
  /** A run that came to no end. */
  readonly run: Track | null;
}

export class Keep {
  /** Writes come one after the other. */
  private queue: Promise<unknown> = Promise.resolve();
  private saved: Partial<Parts> = {};

  private constructor(
    private readonly db: IDBPDatabase<Schema>,
    private readonly onTrouble: () => void,
  ) {}

  /** Null where the browser keeps nothing. `onTrouble` hears of a write that failed: a full disk, storage cleared away. */
  static async open(onTrouble: () => void): Promise<Keep | null> {
    try {
      const db = await openDB<Schema>(NAME, VERSION, {
        upgrade(db) {
          db.createObjectStore("document");
          db.createObjectStore("run");
          db.createObjectStore("snapshots", { keyPath: "iteration" });
        },
        // Another tab wants a newer database: let it.
        blocking: (_current, _wanted, event) => (event.target as IDBDatabase).close(),
        terminated: onTrouble,
      });
      return new Keep(db, onTrouble);
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
    return { doc: docOf(this.saved), run: run ? trackOf({ ...run, snapshots }) : null };
  }

  saveDoc(doc: Doc): Promise<void> {
    return this.write(async (db) => {
      const parts = partsOf(doc);
      const changed = (Object.keys(parts) as (keyof Parts)[]).filter((part) => parts[part] !== this.saved[part]);
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
