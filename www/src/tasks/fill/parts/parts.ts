import "./covered-views";
import "./fill-choices";
import "./shape-pad";
import "./style-shelf";
