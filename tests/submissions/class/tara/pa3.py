import math
import sys
from collections import namedtuple

Sphere = namedtuple("Sphere", "x y z r ka kd ks")
Ray = namedtuple("Ray", "origin direction")


class Scene:
    def __init__(self, filename):
        self.spheres, self.lights = [], []
        self.ambient = (0.0, 0.0, 0.0)
        for number, line in enumerate(open(filename), 1):
            name, *values = line.split() or [""]
            if not name:
                continue
            reader = getattr(self, "read_" + name, None)
            if reader is None:
                sys.exit(f"line {number}: I do not understand {name}")
            reader(*map(float, values))

    def read_eye(self, *v): self.eye = v
    def read_look(self, *v): self.look = v
    def read_up(self, *v): self.up = v
    def read_d(self, d): self.d = d
    def read_bounds(self, *b): self.left, self.right, self.bottom, self.top = b
    def read_res(self, w, h): self.width, self.height = int(w), int(h)
    def read_ambient(self, *rgb): self.ambient = rgb
    def read_light(self, x, y, z, w, r, g, b): self.lights.append(((x, y, z), (r, g, b)))
    def read_recursionlevel(self, n): pass

    def read_sphere(self, x, y, z, r, *k):
        self.spheres.append(Sphere(x, y, z, r, k[0:3], k[3:6], k[6:9]))


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def unit(a):
    n = math.sqrt(dot(a, a))
    return (a[0] / n, a[1] / n, a[2] / n)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def combine(*terms):
    """sum of k * vector over the (k, vector) pairs"""
    return tuple(sum(k * v[c] for k, v in terms) for c in range(3))


def hit(ray, s):
    t = (s.x - ray.origin[0], s.y - ray.origin[1], s.z - ray.origin[2])
    v = dot(t, ray.direction)
    d2 = s.r * s.r - (dot(t, t) - v * v)
    if d2 < 0:
        return None
    return v - math.sqrt(d2)


def closest(scene, ray):
    hits = [(hit(ray, s), k) for k, s in enumerate(scene.spheres)]
    hits = [h for h in hits if h[0] is not None]
    if not hits:
        return None, None
    s, k = min(hits)
    return s, scene.spheres[k]


def colour(scene, ray):
    s, ball = closest(scene, ray)
    if ball is None:
        return (0, 0, 0)
    q = combine((1, ray.origin), (s, ray.direction))
    n = unit((q[0] - ball.x, q[1] - ball.y, q[2] - ball.z))
    total = [a * k for a, k in zip(scene.ambient, ball.ka)]
    for position, power in scene.lights:
        to_light = unit(combine((1, position), (-1, q)))
        cosine = dot(n, to_light)
        if cosine > 0:
            r = combine((2 * cosine, n), (-1, to_light))
            shine = max(0.0, -dot(r, ray.direction)) ** 16
            for c in range(3):
                total[c] += power[c] * (ball.kd[c] * cosine + ball.ks[c] * shine)
    return tuple(min(255, int(255 * t)) for t in total)


def main(driver, picture):
    scene = Scene(driver)
    w = unit(combine((1, scene.eye), (-1, scene.look)))
    u = unit(cross(scene.up, w))
    v = cross(w, u)
    data = bytearray()
    for j in reversed(range(scene.height)):
        py = j / (scene.height - 1) * (scene.top - scene.bottom) + scene.bottom
        for i in range(scene.width):
            px = i / (scene.width - 1) * (scene.right - scene.left) + scene.left
            pixel = combine((1, scene.eye), (scene.d, w), (px, u), (py, v))
            data.extend(colour(scene, Ray(pixel, unit(combine((1, pixel), (-1, scene.eye))))))
    with open(picture, "wb") as f:
        f.write(b"P6\n%d %d\n255\n" % (scene.width, scene.height))
        f.write(data)


if __name__ == "__main__":
    main(*sys.argv[1:3])
