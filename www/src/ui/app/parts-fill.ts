import "../surface/fill-choices";
import "../surface/shape-pad";
import "../surface/style-shelf";
import "../surface/surface-result";
