import "./styles.css";
import { startTheme } from "./ui/shared/theme";

startTheme();
// One after the other: to run all scripts at once would keep a slow machine from answering.
await import("lit");
const { Studio } = await import("./state/studio");
const { before, TASKS } = await import("./tasks/registry");
const { WireApp } = await import("./ui/app/wire-app");

const newWorker = (): Worker => new Worker(new URL("./worker.ts", import.meta.url), { type: "module", name: "wire4d" });
document.body.prepend(new WireApp(new Studio({ tasks: TASKS, before, newWorker }), TASKS));

// What hangs below comes as somebody scrolls there.
const below = document.querySelector(".below")!;
const coming = new IntersectionObserver(([...entries]) => {
  if (!entries.at(-1)!.isIntersecting) return;
  coming.disconnect();
  void import("./gallery/below").then(({ hang }) => hang(below));
}, { rootMargin: "-1px" });
coming.observe(below);
