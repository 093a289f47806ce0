"""A candidate for raycheck in Python; needs only the standard library.

    import raycheck_candidate as rc

    def pixel_ray(camera, conventions, pixel): ...
    def intersect(ray, sphere, conventions): ...

    if __name__ == "__main__":
        rc.run("mine", pixel_ray=pixel_ray, intersect=intersect)

and then `raycheck check SCENE --candidate "command:python3 mine.py"`. The functions, all optional:

    frame(camera) -> (u, v, w)                              the camera's axes
    pixel_point(camera, conventions, pixel) -> point        P
    pixel_ray(camera, conventions, pixel) -> (P, direction) from P, direction unit
    focal_ray(camera, conventions, pixel) -> (E, direction) from the eye
    intersect(ray, sphere, conventions) -> (s, point) or None
    intersect_batch(rays, sphere, conventions) -> a list of the same, one for each ray;
                                                  instead of intersect
    nearest(ray, spheres, conventions) -> index or None
    pick(camera, conventions, pixel, sphere) -> (s, point) or None, the point seen through a pixel

Vectors are tuples (x, y, z), pixels (i, j), rays (origin, direction), spheres (centre, radius).
Declare what your functions fix or promise by its name in `raycheck list`: rc.run("mine",
rows="top-first", t_min=1e-4, lengths=(1e-100, 1e100), precision="single", ...). In single precision
(floats of struct or numpy) all numbers that they receive are floats, and errors are counted in units
of float. roots="as-asked" declares that they follow conventions.roots. If intersect does not return
s and the point, declare what it returns: returns="parameter", "distance" or "squared-distance" for a
number, "point" for a vector, "class" for True or False, "roots" for both roots, (v - d, v + d); None
and False are misses.
Output of the functions goes to standard error. The protocol is that of docs/candidates.md.
"""
import collections
import os
import sys

Camera = collections.namedtuple(
    "Camera", "eye look_at up near left right bottom top width height")
Roots = collections.namedtuple("Roots", "ends t_min t_max unit culling")
USUAL_ROOTS = Roots("[]", 0.0, float("inf"), "absolute", "none")
Conventions = collections.namedtuple("Conventions", "rows samples origin root tangent roots",
                                     defaults=[USUAL_ROOTS])

_FUNCTIONS = ("frame", "pixel_point", "pixel_ray", "focal_ray", "intersect", "intersect_batch",
              "nearest", "pick")


def _words(*values):
    """Numbers, and tuples of them, as words. A float's repr reads back as the same float."""
    for value in values:
        if isinstance(value, (tuple, list)):
            yield from _words(*value)
        else:
            yield repr(float(value))


def _line(*values):
    return " ".join(_words(*values))


def _camera(words):
    numbers = [float(word) for word in words[:14]]
    return Camera(tuple(numbers[0:3]), tuple(numbers[3:6]), tuple(numbers[6:9]), *numbers[9:],
                  int(words[14]), int(words[15]))


def _read(lines, first):
    """A request after its first line, as a dictionary."""
    request = {"function": first[2], "id": first[1]}
    for line in lines:
        kind, *words = line.split()
        if kind == "end":
            return request
        if kind == "conventions":
            request["conventions"] = Conventions(*words)
        elif kind == "roots":
            roots = Roots(words[0], float(words[1]), float(words[2]), *words[3:])
            request["conventions"] = request["conventions"]._replace(roots=roots)
        elif kind == "camera":
            request["camera"] = _camera(words)
        elif kind == "pixels":
            request["pixels"] = [tuple(map(int, next(lines).split()))
                                 for _ in range(int(words[0]))]
        elif kind in ("rays", "spheres"):
            rows = [tuple(map(float, next(lines).split())) for _ in range(int(words[0]))]
            request[kind] = ([(row[:3], row[3:]) for row in rows] if kind == "rays"
                             else [(row[:3], row[3]) for row in rows])
        else:
            raise ValueError(f"no such part of a request: {kind}")
    raise ValueError("the input ends within a request")


def _hit(hit, returns):
    """s and Q of a hit for the reply: 0 for values that are not returned."""
    if returns == "class":
        return 0, (0, 0, 0)
    if returns == "point":
        return 0, tuple(hit)
    if returns == "roots":
        return hit[0], (hit[1], 0, 0)
    return hit if returns == "hit" else (hit, (0, 0, 0))


def _truth(value):
    """Whether a value is True or False, also numpy's."""
    if type(value).__name__ not in ("bool", "bool_"):
        raise TypeError(f"neither True nor False: {value!r}")
    return bool(value)


def _hits(functions, request, sphere):
    asked, rays = request["conventions"], request.get("rays")
    if request["function"] == "pick":
        return [functions["pick"](request["camera"], asked, pixel, sphere)
                for pixel in request["pixels"]]
    if "intersect_batch" in functions:
        return functions["intersect_batch"](rays, sphere, asked)
    return [functions["intersect"](ray, sphere, asked) for ray in rays]


def _answer(functions, returns, request):
    name = request["function"]
    function = functions.get(name)
    if name == "frame":
        return [_line(axis) for axis in function(request["camera"])]
    asked = request["conventions"]
    if name in ("intersect", "pick"):
        lines = []
        for s, sphere in enumerate(request["spheres"]):
            for r, hit in enumerate(_hits(functions, request, sphere)):
                if returns == "class" and hit is not None:
                    hit = _truth(hit)
                if hit is not None and hit is not False:
                    try:
                        line = _line(*_hit(hit, returns))
                    except TypeError:
                        line = ""
                    if len(line.split()) != 4:
                        wanted = "(s, point)" if returns == "hit" else f"the {returns}"
                        raise TypeError(f"{name} returned {hit!r}; return {wanted}, or None")
                    lines.append(f"{r} {s} {line}")
        return lines
    if name == "nearest":
        found = (function(ray, request["spheres"], asked) for ray in request["rays"])
        return ["none" if index is None else str(index) for index in found]
    return [_line(function(request["camera"], asked, pixel)) for pixel in request["pixels"]]


def _place(error):
    """" (rays.py, line 3)": where the program's code failed, or where it called other code."""
    folder = os.path.dirname(os.path.abspath(sys.argv[0]))
    place, step = "", error.__traceback__
    while step:
        path = os.path.abspath(step.tb_frame.f_code.co_filename)
        if os.path.dirname(path) == folder and path != os.path.abspath(__file__):
            place = f" ({os.path.basename(path)}, line {step.tb_lineno})"
        step = step.tb_next
    return place


def _statement(key, value):
    """A declaration as a line: words and numbers, one or several."""
    values = value if isinstance(value, (tuple, list)) else [value]
    words = (word if isinstance(word, str) else repr(float(word)) for word in values)
    return " ".join([key, *words])


def run(name="-", **given):
    """Answers raycheck until it has no more requests: functions, and what they declare."""
    functions = {key: value for key, value in given.items() if callable(value)}
    declared = {key: value for key, value in given.items()
                if not callable(value) and value is not None}
    unknown = set(functions) - set(_FUNCTIONS)
    if unknown:
        sys.exit(f"raycheck_candidate.run: no such function: {', '.join(sorted(unknown))}; "
                 f"the functions are {', '.join(_FUNCTIONS)}")
    replies, sys.stdout = sys.stdout, sys.stderr
    lines = iter(sys.stdin)
    if not next(lines, "").startswith("raycheck "):
        sys.exit("raycheck_candidate.run: not started by --candidate: "
                 "'raycheck 1' is missing on standard input")
    said = [f"raycheck 1 {name}"]
    said += dict.fromkeys(f"function {function.removesuffix('_batch')}" for function in functions)
    said += [_statement(key, value) for key, value in declared.items()]
    print("\n".join(said + ["ready"]), file=replies, flush=True)
    for line in lines:
        request = _read(lines, line.split())
        try:
            body = _answer(functions, declared.get("returns", "hit"), request)
            last = f"end {request['id']}"
        except Exception as error:  # of the functions: its message belongs in the report
            said = " ".join(f"{type(error).__name__}: {error}{_place(error)}".split())
            body, last = [], f"error {request['id']} {said}"
        print("\n".join([f"reply {request['id']}"] + body + [last]), file=replies, flush=True)
