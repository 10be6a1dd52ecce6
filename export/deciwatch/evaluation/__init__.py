"""`deciwatch evaluate`: pose estimates, and every way of filling them in, against the truth."""
