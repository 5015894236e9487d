"""What is done in a chroot with one compiler, step by step."""

from __future__ import annotations

import argparse
import shlex

from .arguments import COMPILERS, CROSS_COMPILERS

HEADERS = "emtr_headers emtr_class_headers emtr_command_headers"
# The sources are read-only: neither bytecode nor pytest's cache is written beside them.
PYTEST = "PYTHONDONTWRITEBYTECODE=1 python3 -m pytest -q -p no:cacheprovider"
CCACHE = (
    "test ! -d /ccache || export CCACHE_DIR=/ccache CCACHE_SLOPPINESS=pch_defines,time_macros "
    "CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache\n"
)
# Away with what was installed; then the packages are installed, used, examined and removed.
PACKAGES = """\
xargs rm < {build}/installed.txt; ldconfig
cmake -S /source -B {build} -DCMAKE_INSTALL_PREFIX=/usr
cmake --build {build} --parallel {jobs} --target emtr emtr_pcl emtr_command
cd {build}; rm -rf debs; cpack -B debs
DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends lintian
DEBIAN_FRONTEND=noninteractive apt-get install -y ./debs/*.deb
cd /; pcl_emtr --version
EMTR_PREFIX=/usr {pytest} /source/tests/consumers/test_snippets.py
lintian --allow-root --fail-on error {build}/debs/*.deb
apt-get remove -y "libemtr[0-9]*"
if ls /usr/bin/pcl_emtr /usr/lib/*/lib*emtr.* 2>/dev/null | grep .; then exit 1; fi
"""
# A process costs a second of emulation, and ctest makes one a test of the engine.
EMULATED_TESTS = """\
cd {build}/tests/cpp; export GTEST_TOTAL_SHARDS=2 GTEST_BRIEF=1
GTEST_SHARD_INDEX=0 ./emtr_tests & GTEST_SHARD_INDEX=1 ./emtr_tests; wait $!
ctest --test-dir {build} -j {jobs} -L 'c_api|pcl' --output-on-failure --no-tests=error
"""
# Status 3 is a pose that is not registered, whose bits count as well.
PAIR = """\
cd {pair}
for preset in default fast thorough paper; do
  pcl_emtr source.xyz target.xyz --preset $preset --seed 1 -o T.txt || test $? = 3
  cat T.txt >> {bits}
done
"""
# The clone's own cache of the compiler would be as new as the clone.
CLONE = """\
cd /root; rm -rf emtr
git -c safe.directory='*' clone -q /source emtr; cd emtr; git log -1 --format=%h
"""
IN_CLONE = """\
test ! -d /ccache || export CCACHE_DIR=/ccache CCACHE_BASEDIR=/root/emtr CCACHE_NOHASHDIR=1
cd /root/emtr; """
PAIR_FOLDER = "/build/pair"


def bits_path(compiler: str) -> str:
    """Where in the chroot the matrices of the generated pair are written."""
    return f"/build/{compiler}.bits"


def steps(compiler: str, arguments: argparse.Namespace) -> list[tuple[str, str]]:
    """The name and the shell script of each step; each needs those before it."""
    if arguments.readme:
        commands = ("tools/quickstart", "tools/check")
        return [("clone", CLONE), *((command, IN_CLONE + command) for command in commands)]
    build = f"/build/{compiler}"
    foreign = arguments.architecture
    c, cxx = CROSS_COMPILERS[foreign] if foreign else COMPILERS[compiler]
    start = f"export CC={c} CXX={cxx}; {CCACHE}"
    compile_ = f"{start}cmake --build {build} --parallel {arguments.jobs}"
    fresh = "" if arguments.reuse else f"rm -rf {build}; "
    tests = f"-R {shlex.quote(arguments.tests)}" if arguments.tests else ""
    # Programs are built as the pages say, by cc and c++: here they are this compiler.
    ours = (
        f"mkdir -p {build}/bin; ln -sf $(command -v {c}) {build}/bin/cc; "
        f"ln -sf $(command -v {cxx}) {build}/bin/c++; export PATH={build}/bin:$PATH; cd /tmp; "
    )
    ctest = (
        f"ctest --test-dir {build} -j {arguments.jobs} {tests} --output-on-failure --no-tests=error"
    )
    if foreign and not tests:
        ctest = EMULATED_TESTS.format(build=build, jobs=arguments.jobs)
    packages = PACKAGES.format(build=build, jobs=arguments.jobs, pytest=PYTEST)
    python = "-DEMTR_BUILD_PYTHON=ON" if foreign else ""
    of_python = f"PYTHONPATH={build}/python python3 /source/tools/wheel_build/registered_pair.py"
    last = ("Python", of_python) if foreign else ("packages", f"{start}{ours}{packages}")
    return [
        ("configure", f"{start}{fresh}cmake -S /source -B {build} -G Ninja -DEMTR_BUILD_TESTS=ON "
         f"{python}"),
        ("libraries, command", f"{compile_} --target emtr emtr_pcl emtr_command"),
        ("headers alone", f"{compile_} --target {HEADERS}"),
        ("tests built", compile_),
        ("ctest", ctest),
        ("install", f"cmake --install {build}; ldconfig; cd /; pcl_emtr --version; "
         f"cp {build}/install_manifest.txt {build}/installed.txt"),  # others install too
        ("programs of the pages", f"{start}{ours}EMTR_PREFIX=/usr/local {PYTEST} "
         "/source/tests/consumers/test_snippets.py"),
        ("consumers", f"{start}{ours}EMTR_BUILD_DIR={build} {PYTEST} /source/tests/consumers "
         "--ignore /source/tests/consumers/test_snippets.py"),
        ("generated pair", PAIR.format(pair=PAIR_FOLDER, bits=bits_path(compiler))),
        last,
    ]  # fmt: skip
