"""Fast Global Registration in a process that has Open3D: a task a line, an answer a line."""

from __future__ import annotations

import json
import sys
import time

import numpy as np

from ..peers.methods import Task
from ..peers.open3d_fgr import fast_global_registration


def main() -> None:
    for line in sys.stdin:
        task = json.loads(line)
        clouds = np.load(task["file"])
        start = time.perf_counter()
        T = fast_global_registration(
            clouds["source"], clouds["target"], Task(task["voxel"], 1, task["seed"])
        )
        seconds = time.perf_counter() - start
        print(json.dumps({"T": T.ravel().tolist(), "seconds": seconds}), flush=True)


if __name__ == "__main__":
    main()
