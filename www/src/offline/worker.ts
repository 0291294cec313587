/**
 * Keeps the page for use without a network: all files of one build in a cache of that build. Pages of the build before go on with
 * theirs until the last of them is closed; files are named after what they hold, so no build gets another one's.
 */

/** Written in by the build: what is kept at once, by addresses relative to this script, and the build's name. */
declare const FILES: readonly string[];
declare const BUILD: string;

/** What is used here of a service worker's own world, which the page's types do not know. */
interface Happening extends Event {
  readonly request: Request;
  readonly data: unknown;
  waitUntil(work: Promise<unknown>): void;
  respondWith(answer: Promise<Response>): void;
}
interface Scope {
  readonly registration: { readonly scope: string };
  readonly clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
  addEventListener(kind: "install" | "activate" | "fetch" | "message", listener: (event: Happening) => void): void;
}

const scope = self as unknown as Scope;
const OURS = "wire4d-page-";
const NAME = OURS + BUILD;
/** What is large and not everybody's is kept once it was used. */
const USED = "wire4d-used";
const here = (file: string): string => new URL(file, scope.registration.scope).href;

scope.addEventListener("install", (event) => event.waitUntil(fill()));
scope.addEventListener("activate", (event) => event.waitUntil(sweep().then(() => scope.clients.claim())));
scope.addEventListener("fetch", (event) => {
  const { request } = event;
  if (request.method !== "GET" || !request.url.startsWith(scope.registration.scope)) return;
  event.respondWith(answer(request));
  if (request.mode === "navigate") event.waitUntil(sweep());
});
/** The person wants this build now. */
scope.addEventListener("message", ({ data }) => {
  if (data === "take over") void scope.skipWaiting();
});

/** What the build before has kept need not be fetched again, unless its name says nothing about what it holds. */
async function fill(): Promise<void> {
  const cache = await caches.open(NAME);
  try {
    await Promise.all(
      FILES.map(async (file) => {
        const kept = isNamedByContents(file) ? await caches.match(here(file)) : undefined;
        const response = kept ?? (await fetch(here(file), { cache: "no-cache" }));
        if (!response.ok) throw new Error(`${file} could not be fetched (${response.status})`);
        await cache.put(here(file), response);
      }),
    );
  } catch (error) {
    await caches.delete(NAME);
    throw error;
  }
}

const isNamedByContents = (file: string): boolean => file.startsWith("assets/");

async function answer(request: Request): Promise<Response> {
  const url = new URL(request.url);
  const own = await caches.open(NAME);
  // What an address says behind ? and # is the page's to read.
  const page = request.mode === "navigate" ? here(url.pathname.endsWith("/") ? "index.html" : url.pathname.split("/").at(-1)!) : request.url;
  const kept = (await own.match(page, { ignoreSearch: request.mode === "navigate" })) ?? (await caches.match(request));
  if (kept) return kept;
  const response = await fetch(request);
  if (response.ok && isNamedByContents(request.url.slice(scope.registration.scope.length))) {
    const copy = response.clone();
    // Where there is no room, it is fetched again another time.
    void caches.open(USED).then((used) => used.put(request, copy)).catch(() => undefined);
  }
  return response;
}

/** Throws away builds of which no page is open. Each page holds a lock with the name of its first script. */
async function sweep(): Promise<void> {
  const { held = [] } = await navigator.locks.query();
  const open = held.flatMap(({ name }) => (name?.startsWith(OURS) ? [name.slice(OURS.length)] : []));
  for (const name of await caches.keys()) {
    if (!name.startsWith(OURS) || name === NAME) continue;
    const cache = await caches.open(name);
    const isInUse = await Promise.all(open.map((script) => cache.match(script)));
    if (!isInUse.some(Boolean)) await caches.delete(name);
  }
}
