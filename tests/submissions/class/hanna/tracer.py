"""hanna's tracer: python3 tracer.py scene image"""
from math import sqrt, inf
import sys


def read(filename):
    scene = dict(sphere=[], light=[])
    for line in open(filename).read().splitlines():
        if line.strip() == '' or line.lstrip()[0] == '#':
            continue
        key, *rest = line.split()
        values = tuple(float(r) for r in rest)
        if key in ('sphere', 'light'):
            scene[key].append(values)
        else:
            scene[key] = values
    if not scene['light']:
        raise ValueError('there is no light')
    for s in scene['sphere']:
        if len(s) not in (16, 17):
            raise ValueError('sphere: %d values' % len(s))
    return scene


def plus(a, b): return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
def minus(a, b): return (a[0] - b[0], a[1] - b[1], a[2] - b[2])
def times(k, a): return (k * a[0], k * a[1], k * a[2])
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def unit(a): return times(1 / sqrt(dot(a, a)), a)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0])


def solve(sphere, start, way):
    """both parameters where the ray meets the sphere"""
    T = minus(sphere[0:3], start)
    v = dot(T, way)
    dd = sphere[3] ** 2 - (dot(T, T) - v ** 2)
    if dd < 0:
        return ()
    d = sqrt(dd)
    return (v + d, v - d)


def first(scene, start, way):
    where, what = inf, None
    for sphere in scene['sphere']:
        for s in solve(sphere, start, way):
            if s >= 0:
                if s < where:
                    where, what = s, sphere
                break
    return where, what


def colour(scene, start, way):
    sphere = first(scene, start, way)[1]
    if sphere is None:
        return [0.0, 0.0, 0.0]
    return [a * k for a, k in zip(scene['ambient'], sphere[4:7])]


def main():
    scene = read(sys.argv[1])
    eye, d = scene['eye'], scene['d'][0]
    w = unit(minus(eye, scene['look']))
    u = unit(cross(scene['up'], w))
    v = cross(w, u)
    left, right, bottom, top = scene['bounds']
    width, height = map(int, scene['res'])
    picture = {}
    for i in range(width):
        px = left + (right - left) * i / (width - 1)
        for j in range(height):
            py = top - (top - bottom) * j / (height - 1)
            p = plus(plus(plus(eye, times(d, w)), times(px, u)), times(py, v))
            picture[i, j] = colour(scene, p, unit(minus(p, eye)))
    with open(sys.argv[2], 'w') as f:
        print('P3', width, height, 255, file=f)
        for j in range(height):
            for i in range(width):
                print(*(min(255, int(256 * c)) for c in picture[i, j]), end='  ', file=f)
            print(file=f)


main()
