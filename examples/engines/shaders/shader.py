"""Shared code of glsl.py and opencl.py: reads a shader file and its declarations.

The file has one function, float hit_sphere(origin, direction, centre, radius), which returns s, or
a negative number for a miss. Comment lines `// raycheck WORD VALUE...` are its declarations, with
the keywords of raycheck_candidate.run (`directions unit`, `returns distance`, `roots [] 0 inf
absolute none`). `// raycheck include PATH` prepends the shader in that file. The file is searched
for in this folder, its parents and their npm/; in a JavaScript module, the shader is the longest
string.
"""
import pathlib
import re

_STRING = re.compile(r'`([^`]*)`|"((?:[^"\\]|\\.)*)"', re.DOTALL)


def _included(path):
    above = pathlib.Path(__file__).resolve().parents
    places = [place / path for folder in above for place in (folder, folder / "npm")]
    found = next(filter(pathlib.Path.exists, places), None)
    if found is None:
        raise SystemExit(f"no file {path} in this folder or one above it")
    text = found.read_text()
    if found.suffix != ".js":
        return text
    string = max((a or b for a, b in _STRING.findall(text)), key=len)
    return string.replace("\\n\\\n", "\n").replace("\\n", "\n")


def read(file):
    """The shader's source, and its keywords for raycheck_candidate.run."""
    source = pathlib.Path(file).read_text()
    declared, parts = {"precision": "single", "level": "ordinary", "lengths": (2.0**-30, 2.0**30)}, []
    for word, value in re.findall(r"^// raycheck (\S+) (.*)$", source, re.MULTILINE):
        if word == "include":
            parts.append(_included(value))
        elif word == "roots":
            ends, t_min, t_max, *rest = value.split()
            declared[word] = (ends, float(t_min), float(t_max), *rest)
        else:
            declared[word] = value
    return "\n".join(parts + [source]), declared


def flat(rays):
    """Origins and directions, one number after the other."""
    return [x for ray in rays for part in ray for x in part]


def hits(answers):
    """Results for raycheck_candidate: None for a miss."""
    return [None if s < 0 else float(s) for s in answers]
