import "../pads/drawing-pad";
import "../pads/remedy-list";
