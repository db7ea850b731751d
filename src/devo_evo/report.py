"""report.html and report.md: every claim of the paper, and what a study says about it."""

import base64
import html
import math
import pathlib

from . import figures
from .claims import ALPHA, CLAIMS, Verdict, judge
from .claims.base import LEAST, PAPER_GENERATIONS
from .errors import DevoEvoError
from .power import POWER

COLUMNS = ("Claim", "Where", "Paper", "Replication", "Ours, with 95 % interval", "Test", "p (Holm)", "n", "Verdict")
_COLOURS = {
    Verdict.HOLDS: "#d9f2e3",
    Verdict.DOES_NOT_HOLD: "#f9dcd6",
    Verdict.TOO_FEW_TRIALS: "#fdf3d0",
    Verdict.TOO_FEW_GENERATIONS: "#fdf3d0",
    Verdict.NO_DATA: "#eeeeee",
}
REPLICATION = (
    "F. Benureau and J. Tani's independent replication, 30 trials a treatment, with the released code's operators"
)


def write(study, folder, say=lambda text: None):
    """Judges every claim, draws every figure, and writes report.html, report.md and the figures into a folder."""
    check(study)
    judgements = judge(CLAIMS, study)
    folder = pathlib.Path(folder)
    drawings = figures.draw_all(study, folder / "figures", say=say)
    try:
        (folder / "report.md").write_text(markdown(study, judgements, drawings), encoding="utf-8")
        (folder / "report.html").write_text(page(study, judgements, drawings), encoding="utf-8")
    except OSError as error:
        raise DevoEvoError(f"the report cannot be written to {folder}: {error.strerror}") from error
    say(f"{folder / 'report.html'}, {folder / 'report.md'}: {summary(judgements)}")
    return judgements


def check(study):
    """Asserts what has to be so before anything is claimed: no selected arm has lost its best robot."""
    for row in study.arms.itertuples():
        archive = study.archive(row.arm)
        if archive is not None and row.selection != "neutral":
            archive.check_elitism()


def summary(judgements):
    """How many claims got which verdict, in one sentence."""
    counts = {verdict: sum(1 for judgement in judgements if judgement.verdict is verdict) for verdict in Verdict}
    return (
        f"of {len(judgements)} claims {counts[Verdict.HOLDS]} hold, {counts[Verdict.DOES_NOT_HOLD]} do not; too few "
        f"trials for {counts[Verdict.TOO_FEW_TRIALS]}, too few generations for {counts[Verdict.TOO_FEW_GENERATIONS]}, "
        f"no data for {counts[Verdict.NO_DATA]}"
    )


def cells(judgement):
    """One row of the table, as text."""
    claim, outcome = judgement.claim, judgement.outcome
    ours = outcome.ours
    if not math.isnan(outcome.interval.low) and 0 < outcome.trials < LEAST:
        ours += f" (of {outcome.trials}: too few for a 95 % interval)"
    if outcome.missing:
        ours = (ours + "; " if ours else "") + f"no data: {outcome.missing}"
    return (
        claim.statement,
        claim.where,
        claim.paper,
        claim.replication,
        ours,
        claim.test,
        probability(judgement),
        str(outcome.trials or "–"),
        judgement.verdict_text,
    )


def probability(judgement):
    """Raw and adjusted p."""
    raw = judgement.outcome.p
    if math.isnan(raw):
        return "–"
    return f"{_p(raw)} ({_p(judgement.adjusted_p)})"


def _p(value):
    return f"{value:.3f}" if value >= 0.001 else f"{value:.1e}"


def power_rows(judgements):
    """The power calculation: claim, effect assumed, trials for 80 % power, trials there are."""
    return [
        (
            judgement.claim.statement,
            judgement.claim.planning,
            str(judgement.trials_needed),
            str(judgement.outcome.trials),
        )
        for judgement in judgements
        if judgement.claim.plan
    ]


def introduction(study):
    """What the report is made of, in sentences."""
    lines = study.notes("evo", "evo_devo")
    if not study.is_study:
        lines.append(
            "This is a single experiment; what a study adds (both treatments, walks, variants, the sweep) is "
            "missing."
        )
    lines += [
        f"A claim holds if its test rejects the null hypothesis at {ALPHA:g} after Holm's correction in its family, "
        "or if its interval lies where the claim puts it. It does not hold if its opposite was shown, or if there were "
        f"enough trials (for {100 * POWER:g} % power at the effect assumed) and generations to show it. Else the "
        "verdict says what there was too little of. Claims, tests and effects were fixed before any data: "
        "docs/statistics.md.",
        f"Replication: {REPLICATION}; its numbers belong to the profile released_code, as the paper's very likely do. "
        "n: independent units (trials, lineages or champions) of the smaller group.",
    ]
    return lines


CONVENTIONS = (
    ("Fast", "at least 30 body lengths in a life; the count at the released code's 10 stands beside it"),
    ("Run champion", f"the best robot of a trial at its last generation (the paper's: {PAPER_GENERATIONS})"),
    ("Trials that are behind", "left out, and named, once others have finished"),
    ("Fig. 3B", "run champions; the median survivors of final populations beside them"),
    ("Fig. 4B", "each design once; the released script counts a survivor once a generation"),
    ("Fig. 6A", "aligned at the first ancestor that rolls, with n shown; the released script pads with zeros"),
    ("Fig. S2", "velocity is displacement over 0.5 s; the released script strobes single time steps"),
    ("Random walks", "champions are resampled, not walks; a step that fails counts as 0"),
    ("63.8175 λ", "a misprint of 63.1875 λ in the paper's table"),
)


def markdown(study, judgements, drawings):
    """The report as Markdown; pictures are linked."""
    lines = [f"# Report on {study.output.resolve().name}", "", summary(judgements).capitalize() + ".", ""]
    lines += [line for text in introduction(study) for line in (text, "")]
    lines += ["## Claims", ""]
    for family in dict.fromkeys(judgement.claim.family for judgement in judgements):
        members = [judgement for judgement in judgements if judgement.claim.family == family]
        lines += [f"### {family.capitalize()}", ""]
        lines += _table(COLUMNS, [cells(judgement) for judgement in members])
    lines += [
        "## How many trials it takes",
        "",
        f"For {100 * POWER:g} % power at the level that Holm's correction leaves the claim at worst.",
        "",
    ]
    lines += _table(("Claim", "Effect assumed", "Trials needed", "Trials there are"), power_rows(judgements))
    lines += (
        ["## Conventions", ""] + [f"- **{name}**: {meaning}." for name, meaning in CONVENTIONS] + ["", "## Figures", ""]
    )
    for drawing, paths in drawings:
        lines += [
            f"![{drawing.title}](figures/{paths[1].name})",
            "",
            f"{drawing.title}. " + " ".join(drawing.notes),
            f"Numbers: [figures/{paths[2].name}](figures/{paths[2].name})",
            "",
        ]
    return "\n".join(lines)


def _table(header, rows):
    escaped = [[str(cell).replace("|", "\\|").replace("\n", " ") for cell in row] for row in rows]
    return [
        "| " + " | ".join(header) + " |",
        "|" + "---|" * len(header),
        *("| " + " | ".join(row) + " |" for row in escaped),
        "",
    ]


def page(study, judgements, drawings):
    """The report as one HTML file, pictures included."""
    title = f"Report on {html.escape(study.output.resolve().name)}"
    parts = [
        "<!DOCTYPE html>",
        '<html lang="en"><head><meta charset="utf-8">',
        f"<title>{title}</title>",
        f"<style>{_STYLE}</style></head><body>",
        f"<h1>{title}</h1>",
        f"<p><b>{html.escape(summary(judgements).capitalize())}.</b></p>",
    ]
    parts += [f"<p>{html.escape(text)}</p>" for text in introduction(study)]
    for family in dict.fromkeys(judgement.claim.family for judgement in judgements):
        members = [judgement for judgement in judgements if judgement.claim.family == family]
        rows = [(cells(judgement), _COLOURS[judgement.verdict]) for judgement in members]
        parts += [f"<h2>{html.escape(family.capitalize())}</h2>", _html_table(COLUMNS, rows)]
    parts += [
        "<h2>How many trials it takes</h2>",
        f"<p>For {100 * POWER:g} % power at the level that Holm's correction leaves the claim at worst.</p>",
        _html_table(
            ("Claim", "Effect assumed", "Trials needed", "Trials there are"),
            [(row, "#ffffff") for row in power_rows(judgements)],
        ),
        "<h2>Conventions</h2><ul>",
    ]
    parts += [f"<li><b>{html.escape(name)}</b>: {html.escape(meaning)}.</li>" for name, meaning in CONVENTIONS]
    parts += ["</ul><h2>Figures</h2>"]
    for drawing, paths in drawings:
        picture = base64.b64encode(paths[1].read_bytes()).decode("ascii")
        parts.append(
            f'<figure><img alt="{html.escape(drawing.title)}" src="data:image/png;base64,{picture}">'
            f"<figcaption>Numbers: figures/{html.escape(paths[2].name)}</figcaption></figure>"
        )
    parts.append("</body></html>")
    return "\n".join(parts) + "\n"


def _html_table(header, rows):
    lines = [
        "<table><thead><tr>" + "".join(f"<th>{html.escape(name)}</th>" for name in header) + "</tr></thead><tbody>"
    ]
    for row, colour in rows:
        row = [html.escape(str(cell)) for cell in row]
        lines.append(
            "<tr>"
            + "".join(f"<td>{cell}</td>" for cell in row[:-1])
            + f'<td style="background:{colour}">{row[-1]}</td></tr>'
        )
    return "\n".join(lines) + "</tbody></table>"


_STYLE = """
body { font: 15px/1.45 sans-serif; margin: 2em auto; max-width: 1280px; padding: 0 1em; color: #222; }
table { border-collapse: collapse; width: 100%; margin: 0.5em 0 1.5em; }
th, td { border: 1px solid #ccc; padding: 4px 7px; text-align: left; vertical-align: top; font-size: 13px; }
th { background: #f3f3f3; }
figure { margin: 2em 0; } img { max-width: 100%; } figcaption { color: #666; font-size: 12px; }
"""
