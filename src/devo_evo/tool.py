"""Where the command-line tool is, and how it is run: what only the C++ library can compute is asked from it."""

import os
import pathlib
import shutil
import subprocess

from .errors import DevoEvoError, InvalidInput

_BAD_INPUT = 2  # exit status: wrong usage, or input that cannot be used


def tool_path():
    """Path of the tool: $DEVO_EVO_TOOL, beside this module (built or installed), or first on the PATH."""
    named = os.environ.get("DEVO_EVO_TOOL")
    if named:
        return named
    module = pathlib.Path(__file__).resolve().parent
    prefix = module.parents[2]  # <prefix>/lib/python3/dist-packages/devo_evo, or <repository>/src/devo_evo
    repository = module.parents[1]
    candidates = [
        prefix / "devo_evo" / "devo_evo",
        prefix.parent / "bin" / "devo_evo",
        repository / "build" / "devel" / "lib" / "devo_evo" / "devo_evo",
        repository / "build" / "devo_evo",
    ]
    for candidate in candidates:
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return str(candidate)
    found = shutil.which("devo_evo")
    if found:
        return found
    raise DevoEvoError("the tool devo_evo is missing; build it, or name it in the environment variable DEVO_EVO_TOOL")


def run_tool(arguments, text=""):
    """Standard output of the tool. `text` is its standard input.

    Raises InvalidInput or DevoEvoError with the tool's own message.
    """
    tool = tool_path()
    try:
        result = subprocess.run([tool, *arguments], input=text, capture_output=True, encoding="utf-8", check=False)
    except OSError as error:
        raise DevoEvoError(f"the tool {tool} cannot be run: {error.strerror}") from error
    if result.returncode != 0:
        message = result.stderr.strip().removeprefix("devo_evo: error: ") or f"exit status {result.returncode}"
        kind = InvalidInput if result.returncode == _BAD_INPUT else DevoEvoError
        raise kind(f"devo_evo {arguments[0]}: {message}")
    return result.stdout
