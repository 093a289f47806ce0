#!/usr/bin/env python3
"""Ray tracer for CS410.  usage: raytracer.py driver.txt image.ppm"""
import math
import sys


class Vec:
    __slots__ = ("x", "y", "z")

    def __init__(self, x, y, z):
        self.x, self.y, self.z = x, y, z

    def __add__(self, o):
        return Vec(self.x + o.x, self.y + o.y, self.z + o.z)

    def __sub__(self, o):
        return Vec(self.x - o.x, self.y - o.y, self.z - o.z)

    def __mul__(self, o):
        if isinstance(o, Vec):
            return Vec(self.x * o.x, self.y * o.y, self.z * o.z)
        return Vec(self.x * o, self.y * o, self.z * o)

    def dot(self, o):
        return self.x * o.x + self.y * o.y + self.z * o.z

    def cross(self, o):
        return Vec(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)

    def norm(self):
        return math.sqrt(self.dot(self))

    def unit(self):
        n = self.norm()
        return Vec(self.x / n, self.y / n, self.z / n)


class Sphere:
    def __init__(self, numbers):
        assert len(numbers) == 17, "sphere: x y z r Ka Kd Ks Kr index"
        self.centre = Vec(*numbers[0:3])
        self.radius = numbers[3]
        self.ka = Vec(*numbers[4:7])

    def hit(self, start, direction):
        t = self.centre - start
        v = t.dot(direction)
        closest = t - direction * v
        dsq = self.radius ** 2 - closest.dot(closest)
        if dsq < 0:
            return None
        d = math.sqrt(dsq)
        for s in (v - d, v + d):
            if s >= 0:
                return s
        return None


def read(path):
    scene = {"spheres": []}
    with open(path) as f:
        for line in f:
            words = line.split("#")[0].split()
            if not words:
                continue
            key = words[0]
            if key == "model":
                continue
            numbers = [float(w) for w in words[1:]]
            if key == "sphere":
                scene["spheres"].append(Sphere(numbers))
            else:
                scene[key] = numbers
    return scene


def nearest(scene, start, direction):
    found = None
    for sphere in scene["spheres"]:
        s = sphere.hit(start, direction)
        if s is not None and (found is None or s < found[0]):
            found = s, sphere
    return found


def shade(scene, start, direction):
    found = nearest(scene, start, direction)
    return Vec(*scene["ambient"]) * found[1].ka if found else Vec(0, 0, 0)


def main():
    scene = read(sys.argv[1])
    c = scene["camera"]
    eye, look, up, d = Vec(*c[0:3]), Vec(*c[3:6]), Vec(*c[6:9]), c[9]
    left, right, bottom, top = scene["bounds"]
    width, height = (int(x) for x in scene["res"])
    int(scene["recursionlevel"][0])
    w = (eye - look).unit()
    u = up.cross(w).unit()
    v = w.cross(u)
    rows = []
    for j in range(height):
        beta = top + j / (height - 1) * (bottom - top)
        row = []
        for i in range(width):
            alpha = left + i / (width - 1) * (right - left)
            ray = w * d + u * alpha + v * beta
            colour = shade(scene, eye + ray, ray.unit())
            row.append(" ".join(str(min(255, round(255 * x))) for x in (colour.x, colour.y, colour.z)))
        rows.append(" ".join(row))
    with open(sys.argv[2], "w") as f:
        f.write(f"P3 {width} {height} 255\n" + "\n".join(rows) + "\n")


main()
