"""Recorded human motion: reading it, and deriving the 33 landmarks from it."""
