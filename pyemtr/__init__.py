"""Global registration of two partially overlapping point clouds by EMTR-SSC.

    result = pyemtr.register(source, target)   # arrays (N, 3) and (M, 3), any unit
    if result.registered:
        moved = result.apply(source)           # in the target's frame

Seven calls are enough for most users:

* :func:`register` finds the transformation that maps source into target.
* :meth:`Result.apply` moves points by it.
* :class:`Cloud` preprocesses a cloud once for many registrations.
* :func:`residuals` measures the distance of each point to the other cloud.
* :func:`align_all` brings many scans of one thing into one frame.
* :class:`Localizer` finds scan after scan in a map.
* :func:`settings` lists the keyword arguments that tune the method.

Every transformation maps source into target, q = R p + t, in the clouds' own unit.
"""

from .extension import _emtr  # the first: it says which library is missing

# isort: split
from ._emtr import kernel_name
from .alternative import Alternative
from .batch.records import PairRecord, PairRecords
from .batch.register_many import register_many
from .cloud import Cloud
from .distances import residuals
from .localizer import Localizer, Location
from .multiway import MultiwayResult, align_all
from .options import Setting, presets, settings
from .problem import Problem
from .progress import Progress
from .registration import register
from .result import Result
from .tasks import TaskAlpha, TaskBeta

__version__: str = _emtr.version()

__all__ = [  # noqa: RUF022 - what everyone needs stands first
    "register",
    "register_many",
    "Result",
    "Cloud",
    "residuals",
    "align_all",
    "MultiwayResult",
    "Localizer",
    "Location",
    "settings",
    "presets",
    "Setting",
    "Alternative",
    "PairRecords",
    "PairRecord",
    "Progress",
    "Problem",
    "TaskAlpha",
    "TaskBeta",
    "kernel_name",
    "__version__",
]
