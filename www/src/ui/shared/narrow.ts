/** The same as in the styles of the layout and of the panels: a stage above a sheet. */
export const NARROW = "(max-width: 819px), (max-width: 1099px) and (orientation: portrait)";
