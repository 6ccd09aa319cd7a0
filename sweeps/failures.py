"""What ends a sweep although its computation is right: workers that are gone, or that cannot work."""

import sys
from concurrent.futures import BrokenExecutor, CancelledError

from stridemap.errors import WorkerError, short

KEPT = "finished tiles are kept: continue with --resume"


def explained(error: BaseException) -> WorkerError | None:
    """The error as one sentence where workers, or the way to them, are its reason; None for all others.

    Parameters
    ----------
    error : BaseException
        What an executor raised when a task was submitted, or a task's future when it was asked.
    """
    distributed = sys.modules.get("distributed")  # if it is not loaded, the error is not one of its errors
    if isinstance(error, BrokenExecutor):
        return WorkerError(
            "a worker process died (out of memory, or a script that sweeps without "
            f'`if __name__ == "__main__":`?); {KEPT}, perhaps with fewer --workers'
        )
    if distributed is not None and isinstance(error, distributed.KilledWorker):
        count = error.allowed_failures + 1
        died = (
            "a worker died at a tile"
            if count == 1
            else f"{count} workers died one after the other at one tile"
        )
        return WorkerError(
            f"{died} (out of memory, or stopped by the cluster?); {KEPT}, perhaps with more memory for each "
            "worker"
        )
    # Dask cancels what was submitted when the connection to its scheduler is lost.
    lost = CancelledError if distributed is None else (CancelledError, distributed.comm.CommClosedError)
    if isinstance(error, lost):
        return WorkerError(f"the connection to the workers was lost, or their scheduler ended; {KEPT}")
    if isinstance(error, ImportError):
        return WorkerError(
            f"a worker cannot load stridemap ({short(str(error))}); install there what is installed here: "
            f"{KEPT}"
        )
    return no_workers(error) if isinstance(error, OSError) else None


def no_workers(error: OSError) -> WorkerError:
    """The sentence for processes that the system does not let us have."""
    return WorkerError(
        f"the worker processes cannot work ({error.strerror or error}); close other programs or raise their "
        "limits (ulimit -n, ulimit -u), or continue with --resume and fewer --workers"
    )
