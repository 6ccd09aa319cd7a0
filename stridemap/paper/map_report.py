"""The paper's map as a page to explore, with the verdicts on its statements."""

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

from stridemap.paper.cycle_tables import cycle_tables
from stridemap.paper.evaluate import evaluate
from stridemap.paper.map_boundaries import map_boundaries
from stridemap.paper.points import KEPT
from stridemap.paper.sweeps import paper_sweeps
from stridemap.paper.typical_branches import typical_branches
from stridemap.services import shown
from stridemap.sweeps.run import Progress
from stridemap.views.report.branches import Given
from stridemap.views.report.references import references_of
from stridemap.views.report.write import ReportSummary, check_out, write_report


def report(
    out: str | Path,
    *,
    claims: str | Path | None = None,
    branches: Sequence[Given] = (),
    sweeps: str | Path | None = None,
    params: Mapping[str, Any] | None = None,
    thin: int = 1,
    workers: int | None = None,
    executor: Executor | None = None,
    progress: Callable[[str, Progress], None] | None = None,
    say: Callable[[str], None] | None = None,
) -> ReportSummary:
    """Write the map of the paper's sweeps, with its boundaries and the verdicts, as one HTML file.

    It needs no network. Cycles are compared with those of the compass, the walker without a wobbling mass.

    Parameters
    ----------
    out : path
        The file.
    claims : path, optional
        A file of verdicts that ``stridemap claims --json`` printed; by default the statements are decided
        from the sweeps.
    branches : sequence of path or Branches, optional
        As for `stridemap.views.write_report`; by default those over the spring stiffness through the typical
        solutions, unless the sweeps are thinned out.
    sweeps, params, thin, workers, executor, progress
        As for `claims`: sweeps that are not finished are run.
    say : callable, optional
        Takes a line that says what is being done when boundaries are computed.

    Raises
    ------
    InputError
        As for `claims` and `stridemap.views.write_report`.
    """
    check_out(out)
    paper = paper_sweeps(sweeps, params, thin, workers=workers, executor=executor, progress=progress)
    verdicts = claims or [claim.to_dict() for claim in evaluate(cycle_tables(paper))]
    curves = map_boundaries(paper, say)
    references = references_of(paper.gaits("compass"), "compass", ["omega"])
    drawn = None if curves.empty else curves
    if not branches and thin == 1:
        branches = [typical_branches(paper, say)]
    with shown("writing the report"):
        return write_report(
            paper.run("map"),
            out,
            verdicts,
            curves=drawn,
            references=references,
            branches=branches,
            kept=KEPT,
        )
