"""What can go wrong, and is not a mistake in the program."""


class DevoEvoError(Exception):
    """The work failed: something cannot be read, written or run. The message says what, where, and what would help."""


class InvalidInput(DevoEvoError, ValueError):
    """Something given cannot be used. The message says what, where, and what is allowed."""


class ArchiveError(DevoEvoError):
    """An archive cannot be read, or contradicts itself."""


class NotBegun(ArchiveError):
    """An archive is empty: its writer was killed between making the file and its first commit, or is there just now."""
