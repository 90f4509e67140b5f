"""Jobs on Dask: a cluster of this machine's own, or one that is running already."""

import logging
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib.util import find_spec
from typing import Any

from core_models.errors import SceneError
from studies.sweep.job import Job, failed, perform

logger = logging.getLogger(__name__)

CONNECT_TIMEOUT = 10.0  # s


def is_installed() -> bool:
    """Whether Dask's distributed scheduler is there; importing it takes seconds."""
    return find_spec("distributed") is not None


@contextmanager
def client_of(scheduler: str | None, workers: int) -> Iterator[Any]:
    """A client of the scheduler at an address, or of a cluster of so many processes that lives as long as this.

    Raises SceneError when nothing answers at the address.
    """
    if scheduler is not None:
        logger.warning("--scheduler %s: waiting up to %g s for its answer", scheduler, CONNECT_TIMEOUT)
    from distributed import Client, LocalCluster

    if scheduler is None:
        with (
            LocalCluster(
                n_workers=workers,
                threads_per_worker=1,
                processes=True,
                dashboard_address=":0",
                silence_logs=50,
            ) as cluster,
            Client(cluster) as client,
        ):
            yield client
        return
    try:
        client = Client(scheduler, timeout=CONNECT_TIMEOUT)
    except (OSError, ValueError) as error:
        raise SceneError(
            f"--scheduler {scheduler}: no Dask scheduler answers there ({type(error).__name__}); start one with "
            "'dask scheduler', and workers with 'dask worker', or leave the option out"
        ) from error
    with client:
        yield client


def results_by_dask(jobs: Sequence[Job], client: Any) -> Iterator[dict[str, Any]]:
    """Results in the order in which they come; a job whose worker is lost is done again by another.

    A scheduler without workers is waited for: those of a queue may come later.
    """
    from distributed import as_completed

    if not client.nthreads():
        address = client.scheduler.address
        logger.warning("%s: has no workers yet, waiting; start some with 'dask worker %s'", address, address)

    futures = {client.submit(perform, job, key=job.key, pure=False): job for job in jobs}
    for future in as_completed(futures):
        job = futures[future]
        error = future.exception()
        yield future.result() if error is None else failed(job.key, f"{type(error).__name__}: {error}")
