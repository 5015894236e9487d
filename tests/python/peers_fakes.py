"""Methods for the tests of the comparison, known by what they do to a run.

A worker process imports this module too, so a method consists of plain data.
"""

import os
import signal
import time
from dataclasses import dataclass

import accuracy_fakes
import numpy as np


@dataclass(frozen=True)
class FakeMethod:
    """Solves exactly, but for the run whose seed is `fails_at`, where it does `how`."""

    name: str
    how: str = ""
    fails_at: int = -1
    modules: tuple = ()

    @property
    def ours(self):
        return self.name.startswith("emtr-")

    def load(self):
        if self.how == "unloadable":
            raise ImportError("no such library")
        warmed = []

        def register(source, target, task):
            if not warmed:  # the warm-up's clouds are one and the same
                warmed.append(True)
                return np.eye(4)
            if task.seed == self.fails_at:
                return misbehave(self.how, source, target)
            return accuracy_fakes.least_squares_pose(source, target)

        return register


def misbehave(how, source, target):
    T = accuracy_fakes.least_squares_pose(source, target)
    if how == "segfault":
        print("a last word", flush=True)
        os.kill(os.getpid(), signal.SIGSEGV)
    if how == "abort":
        os.abort()
    if how == "sleep":
        time.sleep(60)
    if how == "raise":
        raise RuntimeError("not to my taste")
    if how == "skew":
        T[0, 0] += 0.1
    if how == "rotate":
        T = accuracy_fakes.spoil(T, source.mean(axis=0), 20.0, 0.0)
    if how == "translate":
        T[:3, 3] += np.ptp(target, axis=0)
    return T


@dataclass(frozen=True)
class ThreadCounter:
    """Answers with what its process was told of threads, in a matrix."""

    name: str = "counter"

    def load(self):
        def register(source, target, task):
            T = np.eye(4)
            T[0, 3] = float(os.environ["OMP_NUM_THREADS"])
            T[1, 3] = len(os.sched_getaffinity(0))
            T[2, 3] = os.getpid()
            return T

        return register


@dataclass(frozen=True)
class VoxelTeller:
    """Answers with the voxels that it was told, in a matrix; -1 for none."""

    name: str
    ours: bool = False

    def load(self):
        def register(source, target, task):
            T = np.eye(4)
            T[0, 3] = task.voxel
            T[1, 3] = -1.0 if task.refine_voxel is None else task.refine_voxel
            return T

        return register
