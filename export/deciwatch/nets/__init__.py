"""The two nets, one file each, and what they are built of."""
