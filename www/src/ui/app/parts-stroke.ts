import "../run/stroke-choices";
import "../run/turned-views";
import "../subject/subject-pad";
