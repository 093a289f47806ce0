"""A small ray tracer with one mistake, `mistaken.py far-root` or `mistaken.py mirrored`: it takes
the far root where the near one counts, or makes its rays from right to left."""
import math
import sys

import raycheck_candidate as rc

MISTAKE = sys.argv[1]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [x / math.sqrt(dot(a, a)) for x in a]


def pixel_ray(camera, conventions, pixel):
    (i, j), (left, right) = pixel, (camera.left, camera.right)
    if MISTAKE == "mirrored":
        left, right = right, left
    if conventions.rows == "top-first":
        j = camera.height - 1 - j
    alpha = left + (right - left) * i / (camera.width - 1)
    beta = camera.bottom + (camera.top - camera.bottom) * j / (camera.height - 1)
    W = unit([e - a for e, a in zip(camera.eye, camera.look_at)])
    U = unit(cross(camera.up, W))
    sight = [camera.near * w + alpha * u + beta * v for u, v, w in zip(U, cross(W, U), W)]
    return [e + g for e, g in zip(camera.eye, sight)], unit(sight)


def intersect(ray, sphere, conventions):
    (L, D), (C, r) = ray, sphere
    T = [c - l for c, l in zip(C, L)]
    v = dot(T, D)
    d_sq = r * r - dot(cross(T, D), cross(T, D))
    if d_sq < 0:
        return None
    near, far = v - math.sqrt(d_sq), v + math.sqrt(d_sq)
    s = far if MISTAKE == "far-root" or near < 0 else near
    return (s, [l + s * d for l, d in zip(L, D)]) if s >= 0 else None


rc.run(MISTAKE, pixel_ray=pixel_ray, intersect=intersect)
