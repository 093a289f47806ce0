"""A candidate that is right, in Python: rays, intersections and the nearest sphere."""
import math

import raycheck_candidate as rc


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
    return times(1 / math.hypot(*a), a)


def frame(camera):
    w = unit(sub(camera.eye, camera.look_at))
    u = unit(cross(camera.up, w))
    return u, cross(w, u), w


def position(low, high, index, count, samples):
    share = (index + 0.5) / count if samples == "centres" else index / (count - 1)
    return low + (high - low) * share


def sight(camera, asked, pixel):
    i, j = pixel
    u, v, w = frame(camera)
    if asked.rows == "top-first":
        j = camera.height - 1 - j
    alpha = position(camera.left, camera.right, i, camera.width, asked.samples)
    beta = position(camera.bottom, camera.top, j, camera.height, asked.samples)
    return add(times(camera.near, w), add(times(alpha, u), times(beta, v)))


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
    root = math.sqrt(discriminant)
    q = b + root if b >= 0 else b - root
    distance = math.hypot(*to)
    roots = sorted((q / a, (distance - r) * (distance + r) / q if q else 0.0))
    s = roots[0]
    if s < 0 and asked.root == "nearest":
        s = roots[1]
    return None if s < 0 else (s, add(origin, times(s, d)))


def nearest(ray, spheres, asked):
    hits = ((intersect(ray, sphere, asked), k) for k, sphere in enumerate(spheres))
    return min(((hit[0], k) for hit, k in hits if hit), default=(None, None))[1]


if __name__ == "__main__":
    rc.run("right", frame=frame, pixel_point=pixel_point, pixel_ray=pixel_ray,
           focal_ray=focal_ray, intersect=intersect, nearest=nearest)
