import "./styles.css";
import { startTheme } from "./ui/theme";
import "./ui/wire-app";

startTheme();
