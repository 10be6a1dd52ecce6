"""Errors that are the user's to mend."""


class UserError(Exception):
    """Bad input; its message is one sentence saying what was wrong and what to do."""
