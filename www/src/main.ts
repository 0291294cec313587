import "./styles.css";
import { startTheme } from "./ui/shared/theme";

startTheme();
// One after the other: to run all scripts at once would keep a slow machine from answering.
await import("lit");
await import("./state/studio");
await import("./ui/app/wire-app");
