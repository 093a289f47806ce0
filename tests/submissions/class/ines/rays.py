"""Rays and spheres, after lecture 7."""
import math

import raycheck_candidate as rc


def add(a, k, b):
    return tuple(x + k * y for x, y in zip(a, b))


def dot(a, b):
    return math.fsum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.hypot(*a)
    return tuple(x / length for x in a)


def frame(camera):
    w = unit(add(camera.eye, -1, camera.look_at))
    u = unit(cross(camera.up, w))
    return u, cross(w, u), w


def between(first, last, k, count, samples):
    """sample k of count from first to last"""
    if samples == "centres":
        return first + (k + 0.5) / count * (last - first)
    if k == count - 1:
        return last
    return first + k / (count - 1) * (last - first)


def from_eye(camera, conventions, pixel):
    """the vector from the eye to a pixel"""
    i, j = pixel
    low, high = camera.bottom, camera.top
    if conventions.rows == "top-first":
        low, high = high, low
    alpha = between(camera.left, camera.right, i, camera.width, conventions.samples)
    beta = between(low, high, j, camera.height, conventions.samples)
    u, v, w = frame(camera)
    return tuple(camera.near * c + alpha * a + beta * b for a, b, c in zip(u, v, w))


def pixel_point(camera, conventions, pixel):
    return add(camera.eye, 1, from_eye(camera, conventions, pixel))


def pixel_ray(camera, conventions, pixel):
    g = from_eye(camera, conventions, pixel)
    return add(camera.eye, 1, g), unit(g)


def focal_ray(camera, conventions, pixel):
    return camera.eye, unit(from_eye(camera, conventions, pixel))


def intersect(ray, sphere, conventions):
    (start, direction), (centre, radius) = ray, sphere
    to_centre = add(centre, -1, start)
    # the direction may have any length: s counts multiples of it
    length = math.hypot(*direction)
    way = unit(direction)
    v = dot(to_centre, way)
    b = math.hypot(*cross(to_centre, way))
    d_sq = (radius - b) * (radius + b)
    if d_sq < 0 or (d_sq == 0 and conventions.tangent == "miss"):
        return None
    d = math.sqrt(d_sq)
    s = v - d
    if s < 0 and conventions.root == "nearest":
        s = v + d
    if s < 0:
        return None
    return s / length, add(start, s, way)


def nearest(ray, spheres, conventions):
    best = None
    for k, sphere in enumerate(spheres):
        hit = intersect(ray, sphere, conventions)
        if hit is not None and (best is None or hit[0] < best[0]):
            best = hit[0], k
    return None if best is None else best[1]


rc.run("ines", frame=frame, pixel_point=pixel_point, pixel_ray=pixel_ray, focal_ray=focal_ray,
       intersect=intersect, nearest=nearest)
