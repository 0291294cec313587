import "./drawing-pad";
import "./remedy-list";
