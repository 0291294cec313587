import "../surface/covered-views";
import "../surface/fill-choices";
import "../surface/shape-pad";
import "../surface/style-shelf";
