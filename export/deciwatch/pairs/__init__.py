"""Pairs of a real estimator's poses and the truth, from rendered avatars."""
