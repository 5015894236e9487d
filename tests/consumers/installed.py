"""An installation of the libraries, and how programs are built and run against it."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from pathlib import Path


def run(*command: str | Path, **kwargs) -> str:
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, check=False, **kwargs
    )
    assert done.returncode == 0, f"{command}\n{done.stdout}\n{done.stderr}"
    return done.stdout


@dataclass(frozen=True)
class Installed:
    """A prefix, and the environment that programs are built and run in."""

    prefix: Path
    libdir: Path
    environment: dict[str, str]

    @property
    def static(self) -> bool:
        return (self.libdir / "libemtr.a").is_file()

    @property
    def has_class(self) -> bool:
        return (self.prefix / "include/pcl/registration/emtr_ssc.h").is_file()

    def run(self, *command: str | Path, folder: Path) -> str:
        return run(*command, cwd=folder, env=self.environment)


def installed_at(prefix: Path, environment: dict[str, str]) -> Installed:
    (config,) = prefix.rglob("emtrConfig.cmake")
    return Installed(prefix, config.parents[2], environment)
