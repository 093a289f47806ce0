"""Builds the wheel of `pip install .` by CMake, without a network (PEP 517)."""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sysconfig
import tomllib
import zipfile

TOP = pathlib.Path(__file__).resolve().parent.parent
PROJECT = tomllib.loads((TOP / "pyproject.toml").read_text())["project"]
NAME = f"{PROJECT['name']}-{PROJECT['version']}"
# Every Linux has these, and their own loader must load them.
OF_THE_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|pthread|dl|rt|gcc_s|stdc\+\+))\.so\..*")


def build_sdist(directory, settings=None):
    raise NotImplementedError("raycheck is built from its repository: pip install PATH")


def build_wheel(directory, settings=None, metadata=None):
    build = TOP / "build" / "wheel"
    subprocess.run(["cmake", "-S", TOP, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DRAYCHECK_WHEEL=ON", "-DRAYCHECK_WARNINGS=OFF",
                    f"-DPython_EXECUTABLE={sysconfig.get_config_var('BINDIR')}/python3"],
                   check=True)
    if not (build / "python" / "cmake_install.cmake").read_text().count("_core"):
        raise SystemExit("raycheck: the module cannot be built: install pybind11-dev (or put "
                         "pybind11's folder in CMAKE_PREFIX_PATH)")
    subprocess.run(["cmake", "--build", build, "--target", "raycheck_python"], check=True)
    made = build / "python" / "raycheck"
    files = {f"raycheck/{path.name}": path for path in made.iterdir() if path.is_file()}
    module = next(path for path in made.iterdir() if path.name.startswith("_core."))
    loaded = subprocess.run(["ldd", module], check=True, capture_output=True, text=True,
                            env={**os.environ, "LD_LIBRARY_PATH": str(build / "library")}).stdout
    for name, path in re.findall(r"(\S+) => (/\S+)", loaded):
        if not OF_THE_SYSTEM.fullmatch(name):
            files[f"raycheck/{name}"] = pathlib.Path(path)
    return wheel(pathlib.Path(directory), {name: path.read_bytes() for name, path in files.items()})


def wheel(directory, files):
    tag = "{0}-{0}-{1}".format("cp" + sysconfig.get_config_var("py_version_nodot"),
                               re.sub(r"[-.]", "_", sysconfig.get_platform()))
    info = f"{NAME}.dist-info"
    files[f"{info}/METADATA"] = "\n".join(
        ["Metadata-Version: 2.1", f"Name: {PROJECT['name']}", f"Version: {PROJECT['version']}",
         f"Summary: {PROJECT['description']}", f"Requires-Python: {PROJECT['requires-python']}",
         *(f"Requires-Dist: {one}" for one in PROJECT["dependencies"]), ""]).encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: raycheck\nRoot-Is-Purelib: false\n"
                              f"Tag: {tag}\n").encode()
    record = f"{info}/RECORD"
    rows = [f"{name},sha256={digest(data)},{len(data)}" for name, data in files.items()]
    files[record] = "\n".join([*rows, f"{record},,", ""]).encode()
    path = directory / f"{NAME}-{tag}.whl"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            entry = zipfile.ZipInfo(name)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if ".so" in name else 0o644) << 16
            archive.writestr(entry, data)
    return path.name


def digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
