"""Which inner loops run, and that it does not matter."""

import numpy as np
import pytest
import shapes

import pyemtr


def test_named_in_the_result():
    pair = shapes.make_pair(3, 4000)
    result = pyemtr.register(pair.source, pair.target, iterations=2)
    assert result.kernel == pyemtr.kernel_name()
    assert result.kernel in repr(result)


@pytest.mark.parametrize("preset", pyemtr.presets())
def test_the_same_bits(monkeypatch, preset):
    pair = shapes.make_pair(3, 4000)
    found = {}
    for name in ("generic", "avx2", "avx512"):
        monkeypatch.setenv("EMTR_KERNEL", name)
        try:
            assert pyemtr.kernel_name() == name
        except ValueError:
            assert name != "generic"
            continue  # this machine lacks it
        found[name] = pyemtr.register(pair.source, pair.target, seed=4, preset=preset)
    for result in found.values():
        assert shapes.bits(result) == shapes.bits(found["generic"])


def test_one_that_cannot_run(monkeypatch):
    monkeypatch.setenv("EMTR_KERNEL", "sse9")
    with pytest.raises(ValueError, match="'sse9'"):
        pyemtr.kernel_name()
    with pytest.raises(ValueError, match="EMTR_KERNEL"):
        pyemtr.register(np.eye(3), np.eye(3))
