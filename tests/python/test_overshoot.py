"""The measure of tools/bench/cancel, with runs that go on for a known time."""

import signal
import time
from types import SimpleNamespace

import accuracy_fakes  # noqa: F401  (finds emtr_bench)
import pytest
from emtr_bench.overshoot import after_limit, after_signal


def run(reason, seconds):
    def register(**settings):
        time.sleep(seconds)
        return SimpleNamespace(reason=reason, settings=settings)

    return register


def test_after_a_limit():
    assert after_limit(run("time_limit", 0.2), 0.05) >= 0.15
    assert after_limit(run("registered", 0.0), 0.05) is None


def test_after_a_signal():
    before = signal.getsignal(signal.SIGALRM)

    def deaf(**_):  # hears of it when it is through
        signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGALRM])
        time.sleep(0.2)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, [signal.SIGALRM])

    assert after_signal(deaf, 0.05) >= 0.15
    assert after_signal(run("registered", 0.0), 60.0) is None
    assert signal.getsignal(signal.SIGALRM) is before
    with pytest.raises(ZeroDivisionError):
        after_signal(lambda: 1 / 0, 60.0)
    assert signal.getitimer(signal.ITIMER_REAL) == (0.0, 0.0)
