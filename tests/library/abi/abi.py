#!/usr/bin/env python3
"""Compares what programs that are linked with libraycheck rely on (its symbols, and the layouts of
the public headers' types) with a committed baseline of the same compiler.

  abi.py LIBRARY COMPILER             fails where such a program would have to be compiled again
  abi.py LIBRARY COMPILER --accept    writes a new baseline, BASELINES/COMPILER.abi.xz

Additions are reported, not a failure. The baseline is compressed to 1/20: most of it is the layouts
of the standard library's types in public structs.
Exit code: 0 compatible, 1 not, 77 skipped, and why.
"""

import lzma
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
HEADERS = HERE.parent.parent.parent / "include/raycheck"
SKIPPED = 77
ACCEPT = "./run abi --accept"
# Leaves out all that depends on the machine, and types that the public headers do not reach.
PLAIN = ["--drop-private-types", "--drop-undefined-syms", "--exported-interfaces-only",
         "--no-architecture", "--no-comp-dir-path", "--no-corpus-path", "--no-elf-needed",
         "--no-parameter-names", "--no-show-locs", "--no-write-default-sizes"]


def skip(reason):
    print("SKIPPED: " + reason)
    sys.exit(SKIPPED)


def written(library, path):
    subprocess.run(["abidw", "--headers-dir", HEADERS, *PLAIN, "--out-file", path, library],
                   check=True)
    if b"raycheck" not in path.read_bytes() or b"<class-decl" not in path.read_bytes():
        sys.exit(f"{library}: no types; it is compiled without -g")


def difference(before, now, *options):
    """What abidiff says; empty where there is nothing to say."""
    result = subprocess.run(["abidiff", "--leaf-changes-only", "--no-show-locs", *options, before, now], text=True,
                            capture_output=True)
    if result.returncode & 3:  # an error in abidiff or its arguments, not a difference of the interfaces
        sys.exit(f"abidiff: {result.stderr}{result.stdout}")
    return result.stdout.strip() if result.returncode else ""


def main():
    library, compiler = sys.argv[1:3]
    if shutil.which("abidiff") is None:
        skip("abidiff (abigail-tools) is not installed")
    baseline = HERE / f"{compiler}.abi.xz"
    with tempfile.TemporaryDirectory() as folder:
        before, now = pathlib.Path(folder, "before.abi"), pathlib.Path(folder, "now.abi")
        if sys.argv[3:] == ["--accept"]:
            written(library, now)
            baseline.write_bytes(lzma.compress(now.read_bytes(), preset=9))
            print(f"accepted as {baseline}")
            return
        if not baseline.exists():
            skip(f"no baseline for {compiler}; create one with {ACCEPT}")
        before.write_bytes(lzma.decompress(baseline.read_bytes()))
        written(library, now)
        broken = difference(before, now, "--no-added-syms")
        if broken:
            print(broken)
            print(f"\nPrograms that are linked with libraycheck.so.0 break. If that is intended, "
                  f"accept a new baseline: {ACCEPT}")
            sys.exit(1)
        print(difference(before, now) or "same as the baseline")


main()
