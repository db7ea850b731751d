"""SQLite files of devo_evo, read only, as they were at one moment; also while somebody writes to them."""

import os
import pathlib
import sqlite3

import numpy as np
import pandas as pd

from .errors import ArchiveError, NotBegun

CHUNK = 100000  # rows that are converted together


class Database:
    """One file. Everything read from it belongs to the moment of the last `refresh`, at first that of its opening."""

    def __init__(self, path, application_id, version, name):
        """name: of what the file is, for messages. Raises ArchiveError if it is not that, or of another version."""
        self.path, self.name = path, name
        self._connection = _connect(path)
        try:
            self._check(application_id, version)
            self.refresh()
        except Exception:
            self._connection.close()
            raise

    def close(self):
        """Lets go of the file."""
        self._connection.close()

    def refresh(self):
        """Moves on to what has been committed by now."""
        if self._connection.in_transaction:
            self._connection.execute("COMMIT")
        try:
            # A snapshot of SQLite's log holds nobody up. Without a log nobody writes, and a lock would keep others from
            # beginning to: there it is enough to notice it.
            if self._pragma("journal_mode") == "wal":
                self._connection.execute("BEGIN")
            self._data_version = self._pragma("data_version")
        except sqlite3.DatabaseError as error:
            raise ArchiveError(f"{self.name} {self.path}: {error}") from error

    def frame(self, query, parameters=()):
        """The result of a query as a frame."""
        try:
            self._assert_unchanged()
            cursor = self._connection.execute(query, parameters)
            return pd.DataFrame(cursor.fetchall(), columns=[column[0] for column in cursor.description or ()])
        except sqlite3.DatabaseError as error:
            raise ArchiveError(f"{self.name} {self.path}: {error}") from error

    def numbers(self, query, parameters=()):
        """The result of a query whose columns are all numbers (NULL: NaN), for millions of rows: they never stand in
        memory as objects."""
        try:
            self._assert_unchanged()
            cursor = self._connection.execute(query, parameters)
            columns = [column[0] for column in cursor.description]
            chunks = [np.empty((0, len(columns)))]
            for rows in iter(lambda: cursor.fetchmany(CHUNK), []):
                chunks.append(np.array(rows, dtype=float))
            return pd.DataFrame(np.concatenate(chunks), columns=columns)
        except (sqlite3.DatabaseError, ValueError) as error:
            raise ArchiveError(f"{self.name} {self.path}: {error}") from error

    def rows(self, query, parameters=()):
        """The result of a query, row by row."""
        try:
            self._assert_unchanged()
            yield from self._connection.execute(query, parameters)
        except sqlite3.DatabaseError as error:
            raise ArchiveError(f"{self.name} {self.path}: {error}") from error

    def has(self, table):
        """Whether there is a table or view of this name."""
        return any(True for _ in self.rows("SELECT 1 FROM sqlite_master WHERE name = ?", (table,)))

    def _assert_unchanged(self):
        if not self._connection.in_transaction and self._pragma("data_version") != self._data_version:
            raise ArchiveError(f"{self.name} {self.path} has changed since it was opened; call refresh()")

    def _pragma(self, name):
        (value,) = self._connection.execute(f"PRAGMA {name}").fetchone()
        return value

    def _check(self, application_id, version):
        try:
            found, found_version = self._pragma("application_id"), self._pragma("user_version")
            tables = self._connection.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]
        except sqlite3.DatabaseError as error:
            raise ArchiveError(f"{self.name} {self.path}: {error}") from error
        if not found and not tables:
            raise NotBegun(f"{self.name} {self.path} is empty: nothing was committed to it yet")
        if found != application_id:
            raise ArchiveError(f"{self.name} {self.path}: it is a database of another program")
        if found_version != version:
            raise ArchiveError(
                f"{self.name} {self.path}: its tables are of version {found_version}, of which this devo_evo knows "
                f"only {version}"
            )


def _connect(path):
    uri = path.resolve().as_uri()
    if pathlib.Path(str(path) + "-journal").exists() and os.access(path, os.W_OK):
        _undo_what_a_killed_writer_began(uri)
    connection = sqlite3.connect(uri + "?mode=ro", uri=True, isolation_level=None, timeout=10.0)
    try:
        connection.execute("PRAGMA trusted_schema = OFF")
        connection.execute("PRAGMA cell_size_check = ON")
        connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
        return connection
    except sqlite3.DatabaseError as error:
        connection.close()
        log = pathlib.Path(str(path) + "-wal")
        # Where nothing may be written, SQLite cannot share memory with a writer; without a log there is none.
        if os.access(path.parent, os.W_OK) or (log.exists() and log.stat().st_size):
            raise ArchiveError(f"{path}: {error}") from error
    connection = sqlite3.connect(uri + "?immutable=1", uri=True, isolation_level=None)
    connection.execute("PRAGMA trusted_schema = OFF")
    return connection


def _undo_what_a_killed_writer_began(uri):
    """SQLite does that when somebody opens the file who may write."""
    connection = sqlite3.connect(uri + "?mode=rw", uri=True, isolation_level=None, timeout=10.0)
    try:
        connection.execute("PRAGMA trusted_schema = OFF")
        connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    except sqlite3.DatabaseError:
        pass  # whoever reads the file now says what is wrong with it
    finally:
        connection.close()
