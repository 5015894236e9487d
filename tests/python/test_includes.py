"""Every C++ file gets the headers that it needs from itself or from files of ours."""

from __future__ import annotations

from pathlib import Path

import includes
import pytest

ROOT = Path(__file__).resolve().parents[2]
ROOTS = [
    ROOT / folder for folder in ("libemtr/src", "libemtr/include", "tools/pcl_emtr", "tests/cpp")
] + [ROOT / "tests/cpp/support", ROOT / "tests/fuzz"]
FILES = sorted(
    path
    for folder in ("libemtr", "tools", "tests")
    for path in (ROOT / folder).rglob("*")
    if path.suffix in {".cpp", ".h", ".hpp", ".inl"}
)


def test_no_standard_header_is_missing() -> None:
    assert len(FILES) > 300
    assert [line for path in FILES for line in includes.missing(path, ROOTS)] == []


@pytest.mark.parametrize(
    ("text", "header"),
    [
        ("std::int32_t x;", "cstdint"),
        ("std::uint_fast64_t x;", "cstdint"),
        ("std::size_t x;", "cstddef"),
        ("auto x = std::max(1, 2);", "algorithm"),
        ("auto y = std::move(x);", "utility"),
        ("static_assert(std::is_same_v<A, B>);", "type_traits"),
        ("throw std::bad_alloc();", "new"),
        ("#include <vector>\nstd::string x;", "string"),
    ],
)
def test_a_missing_header_is_named(tmp_path: Path, text: str, header: str) -> None:
    path = tmp_path / "a.cpp"
    path.write_text(text)
    (line,) = includes.missing(path, [])
    assert line.startswith(f"{path}: std::") and line.endswith(f"needs <{header}>")
    path.write_text(f"#include <{header}>\n{text}")
    assert list(includes.missing(path, [])) == []


@pytest.mark.parametrize("text", ["auto c = a.cross(b);", "Eigen::Quaterniond q;"])
def test_the_core_of_eigen_is_not_its_geometry(tmp_path: Path, text: str) -> None:
    path = tmp_path / "a.cpp"
    path.write_text(f"#include <Eigen/Core>\n{text}")
    (line,) = includes.missing(path, [])
    assert line.endswith("needs <Eigen/Geometry>")
    for header in ("Eigen/Geometry", "pcl/point_types.h"):
        path.write_text(f"#include <{header}>\n{text}")
        assert list(includes.missing(path, [])) == []


@pytest.mark.parametrize(
    "text",
    [
        "// std::vector\n/* std::string\n */",
        'auto x = "std::cout"; auto y = R"(std::cerr)";',
        '#include "b.h"\nstd::vector<int> x;',  # b.h includes c.h, which includes <vector>
        "#include <stdint.h>\nstd::int8_t x;",
        "std::numeric<int> x; mystd::vector y;",
    ],
)
def test_what_is_declared_is_no_finding(tmp_path: Path, text: str) -> None:
    (tmp_path / "own").mkdir()
    (tmp_path / "b.h").write_text('#include "c.h"\n')
    (tmp_path / "own" / "c.h").write_text('#include <vector>\n#include "b.h"\n')
    (tmp_path / "a.cpp").write_text(text)
    assert list(includes.missing(tmp_path / "a.cpp", [tmp_path / "own"])) == []
