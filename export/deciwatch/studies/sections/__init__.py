"""One file for each section of docs/results.md: its sentences, its table, its plot."""
