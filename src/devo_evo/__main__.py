"""`python3 -m devo_evo figures|report OUTPUT`, which the tool's commands of these names run."""

import argparse
import pathlib
import sys

_PACKAGES = {
    "numpy": "python3-numpy",
    "pandas": "python3-pandas",
    "scipy": "python3-scipy",
    "matplotlib": "python3-matplotlib",
}
_FAILED, _BAD_INPUT = 1, 2


def _parser():
    parser = argparse.ArgumentParser(prog="devo_evo", description="Figures and report of a study.", allow_abbrev=False)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, description in (
        ("figures", "Draw the paper's figures: PDF, PNG and CSV."),
        ("report", "Test every claim of the paper: report.html and report.md."),
    ):
        command = commands.add_parser(name, description=description, help=description, allow_abbrev=False)
        command.add_argument("output", metavar="OUTPUT", help="the folder that a study or an experiment wrote to")
        command.add_argument("--into", metavar="FOLDER", help=f"where to write, instead of OUTPUT/{name}")
        if name == "figures":
            command.add_argument(
                "--only",
                metavar="FIGURE",
                action="append",
                default=[],
                help="a figure to draw, such as 3 or S1; may come several times",
            )
    return parser


def _run(arguments):
    from . import figures, report
    from .study import open_study

    with open_study(arguments.output) as study:
        folder = pathlib.Path(arguments.into or pathlib.Path(arguments.output) / arguments.command)
        if arguments.command == "figures":
            figures.draw_all(study, folder, arguments.only, say=_say)
        else:
            report.write(study, folder, say=_say)


def _say(text):
    print(text, flush=True)


def main():
    """The exit status: 0 done, 1 the work failed, 2 input that cannot be used."""
    arguments = _parser().parse_args()
    try:
        _run(arguments)
    except ModuleNotFoundError as error:
        package = _PACKAGES.get((error.name or "").split(".")[0])
        if package is None:
            raise
        return _fail(
            _FAILED,
            f'the Python package {error.name} is missing; install {package} (group "Analysis" of ' "packages.txt)",
        )
    except BrokenPipeError:
        return _FAILED
    except KeyboardInterrupt:
        return 130
    except Exception as error:  # pylint: disable=broad-except
        from .errors import DevoEvoError, InvalidInput

        if not isinstance(error, DevoEvoError):
            raise
        return _fail(_BAD_INPUT if isinstance(error, InvalidInput) else _FAILED, str(error))
    return 0


def _fail(status, message):
    print(f"devo_evo: error: {message}", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
