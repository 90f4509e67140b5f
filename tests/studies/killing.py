"""Kill a run at random moments, resume it each time, and compare with an undisturbed one.

A hundred kills: python -m tests.studies.killing 100
"""

import json
import multiprocessing
import os
import random
import shutil
import sys
import tempfile
import time
from contextlib import redirect_stdout
from multiprocessing.process import BaseProcess
from pathlib import Path

from studies.checkpointing.checkpoint_file import FILE
from studies.command_line import main as matpoint

RUN = ("run", "taylor-classic", "--wall", "plane", "--checkpoint-every", "40steps")
METHODS = {"fem-explicit": 6, "mpm": 6}
LONGEST = 0.6  # s, from a process's first checkpoint, or from its start, until it is killed
EARLY = 0.2  # part of the kills that come while the process starts
MOST = 10  # kills of one run, so that both methods have their share
PATIENCE = 120.0  # s, until a process has written a checkpoint


def start(*arguments: str) -> BaseProcess:
    """The command in a process of its own: a fork, which has imports and kernels already."""
    process = multiprocessing.get_context("fork").Process(target=_quietly, args=(arguments,))
    process.start()
    return process


def _quietly(arguments: tuple[str, ...]) -> None:
    with open(os.devnull, "w") as nowhere, redirect_stdout(nowhere):
        sys.exit(matpoint(list(arguments)))


def new_run(method: str, folder: Path) -> tuple[str, ...]:
    """Arguments of a run by a method into a folder."""
    return (*RUN, "--method", method, "--resolution", str(METHODS[method]), "--out", str(folder))


def kill_some_time(process: BaseProcess, folder: Path, chance: random.Random) -> bool:
    """Kill a process: mostly some time after it has written a checkpoint, else while it starts; whether it lived."""
    began, before = time.monotonic(), written(folder)
    if chance.random() > EARLY:
        while written(folder) == before and process.is_alive() and time.monotonic() - began < PATIENCE:
            time.sleep(0.005)
    time.sleep(chance.uniform(0.0, LONGEST))
    alive = process.is_alive()
    process.kill()
    process.join()
    return alive


def written(folder: Path) -> int:
    """When the checkpoint in a folder was written [ns]; 0 if there is none."""
    try:
        return (folder / FILE).stat().st_mtime_ns
    except FileNotFoundError:
        return 0


def killed_run(method: str, folder: Path, kills: int, seed: int) -> int:
    """Run into a folder with so many kills, fewer if it ends before, and then to the end; how many there were."""
    chance = random.Random(seed)
    done = 0
    process = start(*new_run(method, folder))
    while done < kills and kill_some_time(process, folder, chance):
        done += 1
        if written(folder):
            process = start("run", "--resume", str(folder))
        else:
            shutil.rmtree(folder, ignore_errors=True)
            process = start(*new_run(method, folder))
    process.join()
    if process.exitcode != 0:
        raise AssertionError(f"{method}, seed {seed}, after {done} kills: status {process.exitcode}")
    return done


def results(folder: Path) -> dict[str, bytes | dict]:
    """What a run has left, but for its cost: all files, and of run.json what the steps have led to."""
    found: dict[str, bytes | dict] = {
        path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.rglob("*") if path.is_file()
    }
    record = json.loads(found["run.json"])
    found["run.json"] = {name: record[name] for name in ("status", "quantities", "conservation", "energies")}
    found["run.json"]["steps"] = record["cost"]["steps"]
    return found


def main(kills: int) -> None:
    """Kill until there have been so many kills, over all methods; say how many runs came out the same."""
    total, runs = 0, 0
    with tempfile.TemporaryDirectory() as room:
        expected = {}
        for method in METHODS:
            with open(os.devnull, "w") as nowhere, redirect_stdout(nowhere):
                matpoint(list(new_run(method, Path(room, method))))
            expected[method] = results(Path(room, method))
        while total < kills:
            method = list(METHODS)[runs % len(METHODS)]
            folder = Path(room, str(runs))
            total += killed_run(method, folder, min(MOST, kills - total), runs)
            runs += 1
            if results(folder) != expected[method]:
                raise AssertionError(f"run {runs} by {method}, kill {total}: the results differ")
            sys.stdout.write(f"{total} kills, {runs} runs, all bitwise the undisturbed ones\n")
            sys.stdout.flush()


if __name__ == "__main__":
    main(int(sys.argv[1]))
