import "./stroke-choices";
import "./turned-views";
import "./subject-pad";
