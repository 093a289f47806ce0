# Zoe's ray tracer, spring 2021
# python3 main.py driver.txt picture.ppm
import sys
from math import sqrt


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def sub(a, b):
    return [p - q for p, q in zip(a, b)]


def madd(a, k, b):
    return [p + k * q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def normalize(a):
    length = sqrt(dot(a, a))
    return [p / length for p in a]


eye = look = up = None
ambient = [0, 0, 0]
spheres = []

for line in open(sys.argv[1]):
    w = line.split()
    if not w or w[0].startswith('#'):
        continue
    if w[0] == 'model':
        continue
    nums = list(map(float, w[1:]))
    if w[0] == 'camera':
        eye, look, up, d = nums[0:3], nums[3:6], nums[6:9], nums[9]
    elif w[0] == 'bounds':
        left, right, bottom, top = nums
    elif w[0] == 'res':
        cols, rows = int(nums[0]), int(nums[1])
    elif w[0] == 'ambient':
        ambient = nums
    elif w[0] == 'sphere':
        assert len(nums) == 21
        spheres.append(nums)

W = normalize(sub(eye, look))
U = normalize(cross(up, W))
V = cross(W, U)


def nearest(origin, direction):
    hit, where = None, float('inf')
    for s in spheres:
        T = sub(s[0:3], origin)
        v = dot(T, direction)
        dd = s[3] ** 2 - (dot(T, T) - v * v)
        if dd < 0:
            continue
        t = v - sqrt(dd)
        if t < 0:
            t = v + sqrt(dd)
        if 0 <= t < where:
            hit, where = s, t
    return hit, where


def color(origin, direction):
    s, t = nearest(origin, direction)
    if s is None:
        return (0, 0, 0)
    return tuple(int(min(1, ambient[k] * s[4 + k]) * 255) for k in range(3))


# image[column][row]
image = [[None] * cols for _ in range(rows)]
for i in range(cols):
    for j in range(rows):
        x = left + i / (cols - 1) * (right - left)
        y = top + j / (rows - 1) * (bottom - top)
        p = madd(madd(madd(eye, d, W), x, U), y, V)
        image[i][j] = color(p, normalize(sub(p, eye)))

with open(sys.argv[2], 'w') as out:
    out.write('P3\n{} {}\n255\n'.format(cols, rows))
    for j in range(rows):
        out.write(' '.join('%d %d %d' % image[i][j] for i in range(cols)) + '\n')
