"""Which frames are watched, and how windows are cut and stitched: the same as `web/sampling/`."""
