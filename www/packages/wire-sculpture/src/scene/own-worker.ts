/** A worker that runs this very module, wherever it comes from. */

/** What the worker is called, so that the module knows it is its own. */
export const WORKER_NAME = "wire-sculpture";

/** The module under its own name: bundled into another one, that one would run in the worker. */
const OWN = /\/wire-sculpture\.js$/;

/** Null where there are no workers; where they are forbidden, the worker may also fail later, or never say anything. */
export function startOwnWorker(given: string | null): Worker | null {
  const url = given ?? import.meta.url;
  if (typeof Worker !== "function" || !(given || OWN.test(url.replace(/[?#].*/, "")))) return null;
  const options = { type: "module", name: WORKER_NAME } as const;
  try {
    const whole = new URL(url, document.baseURI);
    if (whole.origin === location.origin) return new Worker(whole, options);
    // Another origin's script starts no worker, but one's own may import it.
    const blob = URL.createObjectURL(new Blob([`import ${JSON.stringify(whole.href)};`], { type: "text/javascript" }));
    const worker = new Worker(blob, options);
    worker.addEventListener("message", () => URL.revokeObjectURL(blob), { once: true });
    return worker;
  } catch {
    return null;
  }
}
