"""Live playback as the page does it, frame by frame, to measure it."""
