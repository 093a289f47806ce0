"""A student's rays and spheres in Python, right as it stands. A first line MISTAKE = "u_flipped"
makes it wrong in the one way of that name."""
import math
import struct

import raycheck_candidate as rc

MISTAKE = globals().get("MISTAKE", "none")
MISTAKES = ("none", "top_from_right", "u_flipped", "u_and_w_flipped", "no_test_for_t",
            "first_sphere_wins", "normalize_discarded", "axes_dropped", "float_directions",
            "far_root", "mirrored")
if MISTAKE not in MISTAKES:
    raise ValueError(f"no such mistake: {MISTAKE}")


def add(a, b):
    return tuple(x + y for x, y in zip(a, b))


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def scaled(k, a):
    return tuple(k * x for x in a)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normalize(a):
    length = math.hypot(*a)
    return tuple(x / length for x in a)


def to_float(a):
    return struct.unpack("3f", struct.pack("3f", *a))


def frame(camera):
    w = normalize(sub(camera.eye, camera.look_at))
    if MISTAKE == "u_and_w_flipped":
        w = normalize(sub(camera.look_at, camera.eye))
    u = normalize(cross(w, camera.up) if MISTAKE == "u_flipped" else cross(camera.up, w))
    if MISTAKE == "axes_dropped":
        return 3 * ((0.0, 0.0, 0.0),)
    # An up vector near W leaves U askew.
    v = normalize(cross(w, u))
    return cross(v, w), v, w


def position(low, high, index, count, samples):
    share = (index + 0.5) / count if samples == "centres" else index / (count - 1)
    return low + share * (high - low)


def to_pixel(camera, asked, pixel):
    """P - E, without the rounding of P."""
    u, v, w = frame(camera)
    i, j = pixel
    if asked.rows == "top-first":
        j = camera.height - 1 - j
    if MISTAKE == "mirrored":
        i = camera.width - 1 - i
    alpha = position(camera.left, camera.right, i, camera.width, asked.samples)
    top = camera.right if MISTAKE == "top_from_right" else camera.top
    beta = position(camera.bottom, top, j, camera.height, asked.samples)
    return add(add(scaled(camera.near, w), scaled(alpha, u)), scaled(beta, v))


def direction(eye, point, g):
    if MISTAKE == "normalize_discarded":
        d = sub(point, eye)
        normalize(d)
        return d
    d = normalize(g)
    return to_float(d) if MISTAKE == "float_directions" else d


def pixel_point(camera, asked, pixel):
    return add(camera.eye, to_pixel(camera, asked, pixel))


def pixel_ray(camera, asked, pixel):
    g = to_pixel(camera, asked, pixel)
    point = add(camera.eye, g)
    return point, direction(camera.eye, point, g)


def focal_ray(camera, asked, pixel):
    g = to_pixel(camera, asked, pixel)
    return camera.eye, direction(camera.eye, add(camera.eye, g), g)


def roots(ray, sphere):
    """Of a s^2 - 2 b s + c = 0, and the square of half the chord, of unit directions."""
    (origin, d), (centre, r) = ray, sphere
    t = sub(centre, origin)
    if MISTAKE == "normalize_discarded":  # the lecture's, of unit directions
        v = dot(t, d)
        d_sq = r * r - (dot(t, t) - v * v)
        return None if d_sq < 0 else (v - math.sqrt(d_sq), v + math.sqrt(d_sq), d_sq)
    moment = cross(t, d)
    a, b = dot(d, d), dot(t, d)
    discriminant = a * r * r - dot(moment, moment)
    if discriminant < 0:
        return None
    q = b + math.copysign(math.sqrt(discriminant), b)
    distance = math.hypot(*t)
    one = q / a
    other = (distance - r) * (distance + r) / q if q != 0 else 0.0
    return min(one, other), max(one, other), discriminant / a


def intersect(ray, sphere, asked):
    found = roots(ray, sphere)
    if found is None:
        return None
    smaller, larger, d_sq = found
    if d_sq == 0 and asked.tangent == "miss":
        return None
    s = smaller
    may_be_larger = asked.root == "nearest" and MISTAKE != "no_test_for_t"
    if (s < 0 and may_be_larger) or MISTAKE == "far_root":
        s = larger
    if s < 0 and MISTAKE != "no_test_for_t":
        return None
    origin, d = ray
    return s, add(origin, scaled(s, d))


def nearest(ray, spheres, asked):
    best, least = None, 0.0
    for k, sphere in enumerate(spheres):
        hit = intersect(ray, sphere, asked)
        if hit is None:
            continue
        if MISTAKE == "first_sphere_wins":
            return k
        if best is None or hit[0] < least:
            best, least = k, hit[0]
    return best


if __name__ == "__main__":
    rc.run("rays", frame=frame, pixel_point=pixel_point, pixel_ray=pixel_ray,
           focal_ray=focal_ray, intersect=intersect, nearest=nearest)
