"""tools/recipes: the archive of a release, and the recipes that are filled for it."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

import pyemtr

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "tools"))

from recipe_files import archive, program, render  # noqa: E402
from wheel_build.run import Failure  # noqa: E402

needs_git = pytest.mark.skipif(
    shutil.which("git") is None or not (ROOT / ".git").exists(), reason="no clone of git"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    """What the command writes."""
    out = tmp_path_factory.mktemp("recipes")
    assert program.main(["--out", str(out)]) == 0
    return out


@needs_git
def test_the_archive_has_what_a_build_needs_and_the_same_bytes_again(folder, tmp_path) -> None:
    name = f"emtr-{pyemtr.__version__}"
    made = folder / f"{name}.tar.gz"
    with tarfile.open(made) as packed:
        names = packed.getnames()
    assert {name.split("/")[0] for name in names} == {name}
    assert {f"{name}/CMakeLists.txt", f"{name}/{archive.HEADER}", f"{name}/LICENSE"} <= set(names)
    assert archive.made(tmp_path, "HEAD").path.read_bytes() == made.read_bytes()


@needs_git
def test_each_recipe_names_the_version_and_the_archive(folder) -> None:
    made = folder / f"emtr-{pyemtr.__version__}.tar.gz"
    sums = subprocess.run(["sha512sum", str(made)], capture_output=True, text=True, check=True)
    port = (folder / "vcpkg/emtr/portfile.cmake").read_text()
    assert f"SHA512 {sums.stdout.split()[0]})" in port
    assert made.as_uri() in port
    assert json.loads((folder / "vcpkg/emtr/vcpkg.json").read_text())["version"] in made.name
    sums = subprocess.run(["sha256sum", str(made)], capture_output=True, text=True, check=True)
    assert f"sha256: {sums.stdout.split()[0]}\n" in (folder / "conda/recipe.yaml").read_text()
    assert f'"{sums.stdout.split()[0]}  /{made.name}"' in (folder / "docker/Dockerfile").read_text()
    assert (folder / "docker" / made.name).read_bytes() == made.read_bytes()


@needs_git
def test_an_address_is_named_in_place_of_the_file(tmp_path) -> None:
    url = "https://example.org/emtr.tar.gz"
    assert program.main(["--out", str(tmp_path), "--url", url]) == 0
    assert f"url: {url}\n" in (tmp_path / "conda/recipe.yaml").read_text()
    assert f'URLS "{url}"' in (tmp_path / "vcpkg/emtr/portfile.cmake").read_text()


@needs_git
def test_conda_reads_its_recipe(folder) -> None:
    rattler_build = pytest.importorskip("rattler_build", reason="py-rattler-build not installed")
    recipe = rattler_build.Stage0Recipe.from_file(folder / "conda/recipe.yaml")
    variants = {"c_stdlib": ["sysroot"], "python": ["3.12.*"]}
    made = recipe.render(rattler_build.VariantConfig(variants))
    assert {variant.recipe.package.name for variant in made} == {"emtr", "pyemtr"}
    assert {str(variant.recipe.package.version) for variant in made} == {pyemtr.__version__}


@needs_git
def test_a_commit_that_is_not_there_is_an_error(tmp_path, capsys) -> None:
    assert program.main(["--out", str(tmp_path), "--commit", "no-such"]) == 2
    assert "no-such" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_header_without_a_version_is_refused() -> None:
    with pytest.raises(Failure, match="EMTR_VERSION_MAJOR"):
        archive.version_of("#define EMTR_VERSION_MAJOR 1\n")


def test_templates_use_no_word_that_is_not_filled() -> None:
    known = {"ARCHIVE", "SHA256", "SHA512", "URL", "VERSION"}
    templates = [path for path in render.TEMPLATES.rglob("*") if path.is_file()]
    assert templates
    for template in templates:
        assert set(re.findall(r"@([A-Z0-9]+)@", template.read_text())) <= known
