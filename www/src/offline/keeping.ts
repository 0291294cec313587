/** Has the browser keep the page, and tells when a new version of it is ready. */

import { msg } from "@lit/localize";

/** What there is to tell. */
export interface Hears {
  /** A new version waits; `load` shows it in place of this one. */
  ready(load: () => void): void;
  /** It cannot be kept, in a sentence. */
  refused(words: string): void;
}

/** Where nothing can be kept, nothing happens. */
export async function keepOffline(hears: Hears): Promise<void> {
  const { serviceWorker, locks } = navigator as Partial<Pick<Navigator, "serviceWorker" | "locks">>;
  if (!serviceWorker || !locks) return;
  const isFirst = !serviceWorker.controller;
  // Refused in private windows and by some policies, and made a thing of nothing by what blocks it: the page works all the same.
  const registration = await serviceWorker.register("./offline.js", { updateViaCache: "none" }).catch(() => undefined);
  if (!registration) return;
  let isAsked = false;
  const load = (): void => {
    isAsked = true;
    registration.waiting?.postMessage("take over");
  };
  serviceWorker.addEventListener("controllerchange", () => {
    if (isAsked) location.reload();
  });
  const watched = new Set<ServiceWorker>();
  const watch = (worker: ServiceWorker | null): void => {
    if (!worker || watched.has(worker)) return;
    watched.add(worker);
    worker.addEventListener("statechange", () => {
      if (worker.state === "installed" && !isFirst) hears.ready(load);
      if (worker.state === "redundant" && !registration.active) hears.refused(msg("This browser has no room to keep the page for use without a network. Everything works while there is one."));
    });
  };
  if (registration.waiting && !isFirst) hears.ready(load);
  watch(registration.installing);
  registration.addEventListener("updatefound", () => watch(registration.installing));
}
