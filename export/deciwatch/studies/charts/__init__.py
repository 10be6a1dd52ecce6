"""The kinds of plots in docs/results.md."""
