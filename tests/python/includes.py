"""Which headers of the C++ standard library and of Eigen a source needs by its names, and lacks.

Compilers differ in what one standard header includes of another: a file that names std::int32_t
without <cstdint> compiles with one of them and not with the next. A name counts as declared if the
file includes the header of it, or includes a file of ours that does.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path

# Header: names in std, as words or patterns.
NAMES = {
    "algorithm": r"(?:min|max|minmax)(?:_element)?(?=\() (?:stable_|partial_)?sort(?=\() fill "
    r"(?:stable_)?partition(?=\() fill_n copy(?=\() copy_n copy_if clamp any_of all_of none_of "
    r"find(?=\() find_if count(?=\() count_if transform(?=\() lower_bound upper_bound nth_element "
    r"unique(?=\() remove_if reverse(?=\() rotate equal(?=\() (?:push|pop|make)_heap for_each "
    r"swap_ranges lexicographical_compare",
    "array": "array",
    "atomic": r"atomic\w* memory_order\w*",
    "charconv": "from_chars to_chars",
    "chrono": "chrono",
    "cmath": "sqrt abs fabs floor ceil l?l?round pow exp log(?:2|10|1p)? a?(?:sin|cos|tan) atan2 "
    "hypot isfinite isnan isinf fma cbrt ldexp frexp trunc nearbyint copysign fmod nextafter",
    "condition_variable": "condition_variable",
    "cstddef": "size_t ptrdiff_t byte nullptr_t max_align_t",
    "cstdint": r"u?int(?:_fast|_least)?(?:8|16|32|64|ptr|max)_t",
    "cstdio": "FILE f?printf v?snprintf fopen fclose fwrite fread fflush fputs "
    "remove(?=\\() rename",
    "cstdlib": "malloc free calloc getenv exit abort strtod strtou?l?l",
    "cstring": "memcpy memset memcmp memmove memchr strlen strn?cmp strerror strchr strstr",
    "exception": r"exception(?:_ptr)? \w+_exception(?:_ptr)? terminate",
    "fstream": "[io]?fstream",
    "functional": "function less greater plus reference_wrapper c?ref hash",
    "iostream": "cout cerr cin clog",
    "iterator": r"\w+_inserter distance advance next prev \w+_iterator",
    "limits": "numeric_limits",
    "map": "(?:multi)?map",
    "memory": "(?:unique|shared|weak)_ptr make_(?:unique|shared)",
    "mutex": r"(?:recursive_)?mutex \w+_lock lock_guard call_once once_flag",
    "new": "bad_alloc align_val_t nothrow launder",
    "numeric": "accumulate iota inner_product partial_sum gcd",
    "optional": "optional nullopt",
    "random": r"mt19937(?:_64)? \w+_distribution random_device",
    "set": "(?:multi)?set",
    "sstream": "[io]?stringstream",
    "stdexcept": "(?:runtime|logic|length|domain)_error invalid_argument out_of_range",
    "string": "string to_string getline",
    "string_view": "string_view",
    "system_error": "error_code errc system_error",
    "thread": "thread this_thread",
    "tuple": "tuple tie make_tuple forward_as_tuple apply(?=\\()",
    "type_traits": r"is_\w+?_v is_same enable_if(?:_t)? conditional_t decay_t remove_\w+?_t "
    r"(?:true|false)_type",
    "unordered_map": "unordered_(?:multi)?map",
    "unordered_set": "unordered_(?:multi)?set",
    "utility": r"pair make_pair move(?=\() swap(?=\() forward exchange declval \w*index_sequence",
    "variant": r"variant visit get_if monostate",
    "vector": "vector",
}  # fmt: skip
# Eigen's core declares these, which is enough for some versions and not for others. PCL's headers
# bring all of Eigen.
GEOMETRY = re.compile(r"[\w)]\.(?:cross|unitOrthogonal)\(|\bEigen::(?:AngleAxis|Quaternion)")
HAVE_GEOMETRY = {"Eigen/Geometry", "Eigen/Dense", "Eigen/Eigenvalues"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


@cache
def needed_by(header: str) -> re.Pattern[str]:
    return re.compile(rf"\bstd::(?:{'|'.join(NAMES[header].split())})\b")


@cache
def names_in(path: Path, changed: int) -> list[str]:
    """The names that the file includes. A file that changed later is another file to the cache."""
    return INCLUDE.findall(path.read_text())


def code(text: str) -> str:
    """The text without comments, strings and include lines."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.DOTALL)
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.DOTALL)
    return INCLUDE.sub("", re.sub(r'"(?:\\.|[^"\\\n])*"', '""', text))


def included(path: Path, roots: Sequence[Path]) -> set[str]:
    """What the file includes, and what files below the roots that it includes do."""
    found: set[str] = set()
    seen: set[Path] = set()
    todo = [path]
    while todo:
        file = todo.pop()
        if file in seen:
            continue
        seen.add(file)
        names = names_in(file, file.stat().st_mtime_ns)
        found.update(names)
        places = [[folder / name for folder in (file.parent, *roots)] for name in names]
        todo += [own for place in places for own in place if own.is_file()]
    return found


def missing(path: Path, roots: Sequence[Path]) -> Iterator[str]:
    """The headers that the file needs and does not get from itself or files of ours."""
    text = code(path.read_text())
    have = included(path, roots)
    for header in NAMES:
        if header not in have and (use := needed_by(header).search(text)):
            c = f"{header[1:]}.h" if header.startswith("c") else header
            if c not in have:
                yield f"{path}: {use[0]} needs <{header}>"
    by_pcl = any(name.startswith("pcl/") for name in have)
    if not (by_pcl or HAVE_GEOMETRY & have) and (use := GEOMETRY.search(text)):
        yield f"{path}: {use[0]} needs <Eigen/Geometry>"
