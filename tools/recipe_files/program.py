"""Makes the archive, fills the recipes, and tries those that can be tried without their tools."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from wheel_build.run import Failure

from . import archive, tried
from .render import render

DESCRIPTION = """\
Writes the archive of a release, as git has it, and recipes that build emtr from it:

  docker/Dockerfile                 an image with the command pcl_emtr
  conda/recipe.yaml, build.sh       packages of conda, for rattler-build
  vcpkg/emtr/portfile.cmake, ...    an overlay port of vcpkg

Their version is that of emtr.h, and each names the archive with its hash."""

EPILOG = """\
examples:
  tools/recipes
  docker build -t pcl_emtr build/recipes/docker
  rattler-build build --recipe build/recipes/conda/recipe.yaml
  vcpkg install emtr --overlay-ports=build/recipes/vcpkg

exit code: 0; 2 when something could not be made or built."""


def parse(words: Sequence[str] | None = None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="tools/recipes",
        description=DESCRIPTION,
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("--commit", default="HEAD", help="what git archives [%(default)s]")
    add("--out", type=Path, default=archive.REPOSITORY / "build" / "recipes", metavar="FOLDER",
        help="[build/recipes]")  # fmt: skip
    add("--url", help="where the archive will be published [the file that is written]")
    add("--try", dest="tried", action="store_true",
        help="then build from the archive what the recipes of conda and vcpkg build, against the "
        "libraries of this machine and with stand-ins for the functions of vcpkg, and use what "
        "they installed; takes two builds")  # fmt: skip
    return parser.parse_args(words)


def main(words: Sequence[str] | None = None) -> int:
    arguments = parse(words)
    try:
        arguments.out.mkdir(parents=True, exist_ok=True)
        made = archive.made(arguments.out.resolve(), arguments.commit)
        files = render(made, arguments.url or made.path.as_uri(), arguments.out)
        print("\n".join(str(path) for path in [made.path, *files]))
        if arguments.tried:
            tried.conda(made, arguments.out.resolve())
            tried.vcpkg(made, arguments.out.resolve())
    except (Failure, OSError) as failure:
        print(f"tools/recipes: error: {failure}", file=sys.stderr)
        return 2
    return 0
