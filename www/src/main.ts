import "./styles.css";
import { startTheme } from "./ui/app/theme";
import "./ui/app/wire-app";

startTheme();
