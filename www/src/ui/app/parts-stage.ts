import "./notice-list";
import "../run/time-line";
import "../stage/wire-stage";
