"""The claims as a Markdown table: `python3 -m devo_evo.claims.listing` prints what stands in docs/statistics.md."""

from . import CLAIMS, planned_trials

HEADER = ("Claim", "Estimand", "Test", "Effect assumed", "Trials", "Generations")


def rows():
    """One row for each claim, families as headings before them: (family, cells)."""
    for claim in CLAIMS:
        trials = str(planned_trials(claim, CLAIMS)) if claim.plan else "–"
        generations = f"{claim.generations}" + (", not before" if claim.final else "") if claim.generations else "–"
        yield claim.family, (
            f"{claim.statement} ({claim.where})",
            claim.estimand,
            claim.test,
            claim.planning or "–",
            trials,
            generations,
        )


def markdown():
    """The table, a heading for each family."""
    lines, family = [], None
    for name, cells in rows():
        if name != family:
            lines += ["", f"### {name.capitalize()}", "", "| " + " | ".join(HEADER) + " |", "|" + "---|" * len(HEADER)]
            family = name
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    return "\n".join(lines[1:]) + "\n"


if __name__ == "__main__":
    print(markdown(), end="")
