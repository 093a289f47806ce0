"""Compares verdicts between releases of the engines.

    releases.py RAYCHECK BUILD [--newer FOLDER] [--write DOCS] [--cases N] [NAME ...]

Judges the older `releases` (engines.toml) of npm's packages, each installed in a new folder, and compares them with
each other and with docs/field.md, which is of Debian 12. FOLDER is a copy of docs that `./run field --write` wrote on
Debian 13; it is compared with docs. `changed` in engines.toml contains the reasons, by the first release with the change.
Prints the table of changes; with --write it makes DOCS/field-releases.md.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

import field
from tables import HEAD, line, rows_of

DOCS = field.HERE.parent.parent / "docs"
COMPARED = HEAD[2:11]  # the levels and the frontiers
INTRODUCTION = """# The field, between releases

What changed in the verdicts of [the field](field.md) between releases: older releases of npm's packages and, with
`--newer`, the packages of Debian 12 and Debian 13. *after* is the first release judged that has the change, *before* the last one judged that has not;
npm releases between these two, if any, were not judged. `./run field --releases` writes this page; the reasons were read in
both releases' sources and are in [engines.toml](../examples/engines/engines.toml).
"""
WITHOUT_NEWER = """
This page has only npm's packages: `--newer FOLDER` adds those of Debian 13.
"""


def verdict_of(row):
    return dict(zip(HEAD, re.split(r" \| ", row[2:-2])))


def upstream(version):
    """A Debian package's version, without Debian's additions."""
    return re.sub(r"^\d+:|[+-].*$", "", version)


def documented(docs):
    """The version and the verdict of each engine on the pages of DOCS."""
    found = {}
    for name, row in rows_of((docs / "field.md").read_text()).items():
        version = re.search(r"^Package: \S+ (\S+)\. ", (docs / "field" / f"{name}.md").read_text(), re.M)
        if version:
            found[name] = version[1], verdict_of(row)
    return found


def judged(engine, version, raycheck, build):
    """The verdict on an engine, with another release of its package; None if npm cannot install this release."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="release.", dir=build))
    try:
        folder.chmod(0o755)  # candidates run as another user
        shutil.copytree(build / "field", folder / "field", ignore=shutil.ignore_patterns("node_modules", "package*.json"))
        (folder / "field/npm/package.json").write_text('{"private": true, "type": "module"}')
        subprocess.run(["npm", "install", "--ignore-scripts", "--legacy-peer-deps", "--no-audit", "--no-fund", "--silent",
                        f"{engine['package']}@{version}"], cwd=folder / "field/npm", check=True)
        return verdict_of(line(field.Page(engine, raycheck, folder).row()))
    except subprocess.CalledProcessError:
        return None
    finally:
        shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("raycheck", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--newer", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--write", type=pathlib.Path, metavar="DOCS")
    parser.add_argument("--cases", type=int, default=500)
    parser.add_argument("names", nargs="*")
    options = parser.parse_intermixed_args()
    if options.write and options.names:
        parser.error("--write writes the whole page: leave out the names of engines")
    raycheck = field.Raycheck(options.raycheck, options.cases)
    engines = tomllib.loads((field.HERE / "engines.toml").read_text())["engine"]
    engines = [engine for engine in engines if not options.names or engine["name"] in options.names]
    here, newer = documented(DOCS), documented(options.newer) if options.newer else {}
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = {(engine["name"], version): pool.submit(judged, engine, version, raycheck, options.build.resolve())
                for engine in engines for version in engine.get("releases", [])}
    rows, same, missing = [], [], []
    for engine in engines:
        name, reasons = engine["name"], dict(engine.get("changed", {}))
        # A page of the same version was not judged on Debian 13, whose packages all have other versions.
        if name not in here or not engine.get("releases") and newer.get(name, here[name])[0] == here[name][0]:
            continue
        judged_ones = {version: jobs[name, version].result() for version in engine.get("releases", [])}
        absent = [version for version, verdict in judged_ones.items() if verdict is None]
        missing += [f"- {engine['library']} {version} (or a package that it needs)" for version in absent]
        releases = [(version, verdict) for version, verdict in judged_ones.items() if verdict] + [here[name]]
        if not engine.get("releases"):
            releases = [(f"{upstream(version)} (Debian {debian})", verdict) for debian, (version, verdict)
                        in ((12, here[name]), (13, newer[name]))]
        listed = len(rows)
        for (before, old), (after, new) in zip(releases, releases[1:]):
            cells = "; ".join(f"{title}: {old[title]} → {new[title]}" for title in COMPARED if old[title] != new[title])
            reason = reasons.pop(after.split()[0], "")
            if cells or reason:
                rows.append([engine["library"], f"`{engine['function']}`", before, after, cells or "no verdict", reason or "not known"])
        if reasons and not absent:
            sys.exit(f"field: {name}: `changed` in engines.toml names a release that is not in `releases`: {', '.join(reasons)}")
        if len(rows) == listed and len(releases) > 1:
            versions = [version for version, _ in releases]
            if len({version.split()[0] for version in versions}) == 1:
                versions = [f"{versions[0].split()[0]}, as built for Debian 12 and Debian 13"]
            same.append(f"- {engine['library']}, `{engine['function']}`: {', '.join(versions)}")
    head = ["library", "function", "before", "after", "what changed", "why"]
    text = "\n".join([*("| " + " | ".join(row) + " |" for row in [head, ["---"] * len(head), *rows]),
                      "", "## The same in every release judged", "", *same,
                      *(["", "## No longer in npm's registry", "", *missing] if missing else [])]) + "\n"
    print(text)
    if options.write:
        (options.write / "field-releases.md").write_text(INTRODUCTION + ("" if options.newer else WITHOUT_NEWER) + "\n" + text)


if __name__ == "__main__":
    main()
