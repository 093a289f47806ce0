"""Compiles every file of raycheck with -fsyntax-only: python3 syntax.py SOURCE BUILD."""

import concurrent.futures
import json
import os
import shlex
import subprocess
import sys


def checked(command):
    """The compiler's errors for a file; None if the file compiles."""
    words = shlex.split(command["command"])
    at = words.index("-o")
    words[at : at + 2] = ["-fsyntax-only"]
    done = subprocess.run(words, cwd=command["directory"], capture_output=True, text=True)
    return done.stderr or f"{command['file']}: the compiler ended with exit code {done.returncode}" if done.returncode else None


def main():
    source, build = sys.argv[1:]
    options = ["CMAKE_BUILD_TYPE=Release", "CMAKE_CXX_COMPILER=g++", "RAYCHECK_WERROR=ON", "RAYCHECK_FEWER_TARGETS=ON"]
    subprocess.run(["cmake", "-S", source, "-B", build, "-G", "Ninja", "-Wno-dev"] + ["-D" + option for option in options],
                   check=True, stdout=subprocess.DEVNULL)
    with open(f"{build}/compile_commands.json", encoding="utf-8") as file:
        commands = json.load(file)
    precompiled = [command for command in commands if command["output"].endswith(".gch")]
    generated = [f"{build}/tools/view/assets.cpp"] + [command["output"] for command in precompiled]
    subprocess.run(["ninja", "-C", build, "--quiet", *generated], check=True)
    # Engines need further packages; .ci/nightly judges them.
    commands = [command for command in commands if command not in precompiled and "/engines/" not in command["file"]]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = [text for text in pool.map(checked, commands) if text]
    print(f"{len(commands)} files compile on {open('/etc/debian_version').read().strip()}" if not failed else "\n".join(failed))
    sys.exit(bool(failed))


main()
