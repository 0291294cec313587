import "../guidance/guide-fold";
import "../lesson/class-fold";
import "../run/result-panel";
import "../run/run-panel";
import "../run/wire-comparison";
import "../save/save-panel";
import "../settings/look-panel";
import "../settings/settings-panel";
