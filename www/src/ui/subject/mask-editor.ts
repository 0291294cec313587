/** Stands in for the editor. */
export {};
