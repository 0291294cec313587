import "./styles.css";
import "./ui/wire-app";
