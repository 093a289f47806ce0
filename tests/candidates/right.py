"""A right candidate, and submission, in Python: rays, intersections and the
nearest sphere. A first line MISTAKE = "far_root" selects a mistake."""
import math

import raycheck_candidate as rc

MISTAKE = globals().get("MISTAKE", "none")
if MISTAKE not in ("none", "axes_dropped", "far_root", "first_sphere_wins"):
    raise ValueError(f"no such mistake: {MISTAKE}")


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.hypot(*a)
    return tuple(x / length for x in a)


def frame(camera):
    w = unit(sub(camera.eye, camera.look_at))
    u = unit(cross(camera.up, w))
    if MISTAKE == "axes_dropped":
        return 3 * ((0.0, 0.0, 0.0),)
    # With an up vector near W, U is inaccurate.
    v = unit(cross(w, u))
    return cross(v, w), v, w


def position(first, last, index, count, samples):
    offset, steps = {"edges": (0, count - 1), "centres": (0.5, count), "corners": (0, count)}[samples]
    return first + (index + offset) / steps * (last - first)


def sight(camera, asked, pixel):
    """P - E, without the rounding of P."""
    i, j = pixel
    u, v, w = frame(camera)
    first, last = camera.bottom, camera.top
    if asked.rows == "top-first":
        first, last = last, first
    alpha = position(camera.left, camera.right, i, camera.width, asked.samples)
    beta = position(first, last, j, camera.height, asked.samples)
    return add(add(times(camera.near, w), times(alpha, u)), times(beta, v))


def pixel_point(camera, asked, pixel):
    return add(camera.eye, sight(camera, asked, pixel))


def pixel_ray(camera, asked, pixel):
    g = sight(camera, asked, pixel)
    return add(camera.eye, g), unit(g)


def focal_ray(camera, asked, pixel):
    return camera.eye, unit(sight(camera, asked, pixel))


def intersect(ray, sphere, asked):
    (origin, d), (centre, r) = ray, sphere
    to = sub(centre, origin)
    a, b = dot(d, d), dot(to, d)
    moment = cross(to, d)
    discriminant = a * r * r - dot(moment, moment)
    if discriminant < 0 or (discriminant == 0 and asked.tangent == "miss"):
        return None
    q = b + math.copysign(math.sqrt(discriminant), b)
    distance = math.hypot(*to)
    roots = sorted((q / a, (distance - r) * (distance + r) / q if q else 0.0))
    s = roots[0]
    if (s < 0 and asked.root == "nearest") or MISTAKE == "far_root":
        s = roots[1]
    return None if s < 0 else (s, add(origin, times(s, d)))


def nearest(ray, spheres, asked):
    hits = ((intersect(ray, sphere, asked), k) for k, sphere in enumerate(spheres))
    if MISTAKE == "first_sphere_wins":
        return next((k for hit, k in hits if hit), None)
    return min(((hit[0], k) for hit, k in hits if hit), default=(None, None))[1]


if __name__ == "__main__":
    rc.run("right", frame=frame, pixel_point=pixel_point, pixel_ray=pixel_ray,
           focal_ray=focal_ray, intersect=intersect, nearest=nearest, corners="as-asked")
