import "./notice-list";
import "./time-line";
import "./wire-stage";
