import "../settings/look-panel";
import "../run/result-panel";
import "../run/run-choices";
import "../run/run-panel";
import "../save/save-panel";
import "../settings/settings-panel";
