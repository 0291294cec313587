import "./look-panel";
import "./result-panel";
import "./run-choices";
import "./run-panel";
import "./save-panel";
import "./settings-panel";
