import "./styles.css";
import { startTheme } from "./ui/shared/theme";
import { openWords } from "./words/open";

startTheme();
const words = openWords();
// So the worker that keeps the page knows of which build this one is, as long as it is open.
void navigator.locks?.request(`wire4d-page-${import.meta.url}`, { mode: "shared" }, () => new Promise(() => undefined));
// One after the other: to run all scripts at once would keep a slow machine from answering.
await import("lit");
await words;
const { Studio } = await import("./state/studio");
const { before, TASKS } = await import("./tasks/registry");
const { WireApp } = await import("./ui/app/wire-app");

const newWorker = (): Worker => new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "wire4d" });
const studio = new Studio({ tasks: TASKS, before, newWorker });
document.body.prepend(new WireApp(studio, TASKS));

// What hangs below comes as somebody scrolls there.
const below = document.querySelector(".below")!;
const coming = new IntersectionObserver(([...entries]) => {
  if (!entries.at(-1)!.isIntersecting) return;
  coming.disconnect();
  void import("./gallery/below").then(({ hang }) => hang(below));
}, { rootMargin: "-1px" });
coming.observe(below);

/** Until the page has come to rest, its files are more urgent than their keeping. */
const REST_MS = 4000;
if (import.meta.env.PROD) {
  setTimeout(async () => {
    const { keepOffline } = await import("./offline/keeping");
    const { store } = studio;
    void keepOffline({
      ready: (load) => store.set({ loadNew: load }),
      refused: (words) => store.set({ notices: [...store.get().notices, words] }),
    });
  }, REST_MS);
}
