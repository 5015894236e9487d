"""In one process with others: many registrations at once, forked children, other libraries."""

import concurrent.futures
import importlib.util
import locale
import multiprocessing
import os
import random
import signal
import subprocess
import sys
import textwrap

import numpy as np
import pytest
from children import environment

import pyemtr

QUICK = {"preset": "paper", "iterations": 20}


def bits(pair, seed=0, **settings):
    return pyemtr.register(
        pair.source, pair.target, seed=seed, **{**QUICK, **settings}
    ).transformation.tobytes()


def child(code, tmp_path, **variables):
    """Runs code that has a pair and its bits; returns what it prints."""
    start = """
        import numpy, sys, shapes
        pair = shapes.make_pair(1)
        def bits(seed=0):
            return pyemtr.register(pair.source, pair.target, seed=seed, preset="paper",
                                   iterations=20, threads=3).transformation.tobytes()
    """
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(start) + textwrap.dedent(code)],
        text=True,
        capture_output=True,
        check=False,
        timeout=600,
        cwd=tmp_path,
        env=environment() | variables,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_sixteen_at_once_are_each_as_if_alone(pair):
    alone = [bits(pair, seed, threads=1) for seed in range(8)]
    assert len(set(alone)) > 1
    with concurrent.futures.ThreadPoolExecutor(16) as pool:
        together = list(pool.map(lambda i: bits(pair, i % 8, threads=1 + i % 3), range(16)))
    assert together == alone + alone


FORKED = """
    import os, signal, pyemtr
    before = bits()
    pid = os.fork()
    if pid == 0:
        signal.alarm(300)  # a child that hangs is ended
        os._exit(0 if bits() == before else 1)
    print(os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]))
"""


def test_a_forked_child_registers_and_ends(tmp_path):
    assert child(FORKED, tmp_path) == "0\n"


def of_seed(seed):
    import shapes

    return bits(shapes.make_pair(1), seed, threads=2)


@pytest.mark.parametrize("method", ["fork", "forkserver"])
def test_a_pool_of_forked_processes(pair, method):
    alone = [bits(pair, seed, threads=2) for seed in range(4)]
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map_async(of_seed, range(4)).get(timeout=600) == alone


def needs(*modules):
    missing = [name for name in modules if importlib.util.find_spec(name) is None]
    return pytest.mark.skipif(
        bool(missing),
        reason=f"no {' or '.join(missing)} in this "
        "environment: tools/coexistence makes one that has them",
    )


BOTH_ORDERS = """
    {imports}
    before = bits()
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(pair.source))
    cloud.estimate_normals()
    cloud.voxel_down_sample(0.05)
    assert bits() == before
    sys.stdout.write(before.hex())
"""


@needs("open3d")
@pytest.mark.parametrize("imports", ["import open3d, pyemtr", "import pyemtr, open3d"])
def test_beside_open3d_in_either_order(pair, imports, tmp_path):
    assert child(BOTH_ORDERS.format(imports=imports), tmp_path) == bits(pair).hex()


OPENMP_USERS = """
    {imports}
    from sklearn.cluster import KMeans
    from scipy.spatial import cKDTree
    def others():
        centers = KMeans(4, n_init=1, random_state=0).fit(pair.source).cluster_centers_
        near = cKDTree(pair.source).query(pair.target, workers=2)[0]
        return centers.tobytes() + near.tobytes() + (pair.source.T @ pair.source).tobytes()
    theirs, before = others(), bits()
    assert others() == theirs and bits() == before
    sys.stdout.write(before.hex())
"""


@needs("sklearn", "scipy")
@pytest.mark.parametrize(
    "imports", ["import sklearn.cluster, pyemtr", "import pyemtr, sklearn.cluster"]
)
def test_beside_users_of_openmp_in_either_order(pair, imports, tmp_path):
    assert child(OPENMP_USERS.format(imports=imports), tmp_path) == bits(pair).hex()


def test_nothing_is_written(pair, capfd):
    pyemtr.register(
        pair.source, pair.target, iterations=3, fallback_search="always", fallback_points=3000
    )
    with pytest.raises(ValueError):
        pyemtr.register(pair.source[:5], pair.target)
    with pytest.raises(ValueError):
        pyemtr.register(pair.source, np.zeros((50, 3)))
    with pytest.raises(ValueError):
        pyemtr.register(pair.source, pair.target, population=-1)
    assert capfd.readouterr() == ("", "")


def test_the_process_is_as_it_was(pair, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def state():
        handlers = [signal.getsignal(number) for number in signal.valid_signals()]
        return (
            locale.setlocale(locale.LC_ALL),
            os.getcwd(),
            handlers,
            dict(os.environ),
            random.getstate(),
            np.random.get_state()[1].tolist(),  # noqa: NPY002 - it is the global one that counts
            np.geterr(),
            signal.pthread_sigmask(signal.SIG_BLOCK, []),
            os.umask(os.umask(0o22)),
            len(os.listdir("/proc/self/fd")),
        )

    before = state()
    bits(pair, threads=3)
    assert state() == before
