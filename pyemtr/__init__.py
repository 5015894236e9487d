"""Global registration of two partially overlapping point clouds by EMTR-SSC.

    result = pyemtr.register(source, target)   # arrays (N, 3) and (M, 3), any unit
    if result.registered:
        moved = result.apply(source)           # in the target's frame

Every transformation maps source into target, q = R p + t.
"""

from . import _emtr
from ._emtr import kernel_name
from .alternative import Alternative
from .cloud import Cloud
from .distances import residuals
from .options import Setting, presets, settings
from .problem import Problem
from .progress import Progress
from .registration import register
from .result import Result
from .tasks import TaskAlpha, TaskBeta

__version__: str = _emtr.version()

__all__ = [
    "Alternative",
    "Cloud",
    "Problem",
    "Progress",
    "Result",
    "Setting",
    "TaskAlpha",
    "TaskBeta",
    "__version__",
    "kernel_name",
    "presets",
    "register",
    "residuals",
    "settings",
]
