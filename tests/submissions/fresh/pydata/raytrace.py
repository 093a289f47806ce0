#!/usr/bin/env python3
"""PA3: casts one ray per pixel.  raytrace.py --driver scene.txt --image scene.ppm"""
from __future__ import annotations

import argparse
import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterator, List, NamedTuple, Optional, Tuple


class V3(NamedTuple):
    x: float
    y: float
    z: float

    def __add__(self, o):
        return V3(self.x + o.x, self.y + o.y, self.z + o.z)

    def __sub__(self, o):
        return V3(self.x - o.x, self.y - o.y, self.z - o.z)

    def __mul__(self, k):
        return V3(self.x * k, self.y * k, self.z * k)

    def __matmul__(self, o):
        return self.x * o.x + self.y * o.y + self.z * o.z

    def cross(self, o):
        return V3(self.y * o.z - self.z * o.y, self.z * o.x - self.x * o.z, self.x * o.y - self.y * o.x)

    def unit(self):
        return self * (1.0 / math.sqrt(self @ self))


@dataclass(frozen=True)
class Ray:
    start: V3
    way: V3

    def at(self, s: float) -> V3:
        return self.start + self.way * s


@dataclass(frozen=True)
class Sphere:
    center: V3
    r: float
    ka: V3
    kd: V3
    ks: V3

    def hit(self, ray: Ray) -> Optional[float]:
        t = self.center - ray.start
        v = t @ ray.way
        d2 = self.r ** 2 - (t @ t - v * v)
        if d2 < 0:
            return None
        d = math.sqrt(d2)
        s = min(v - d, v + d, key=abs)
        return s if s >= 0 else None


@dataclass(frozen=True)
class Light:
    pos: V3
    w: float
    rgb: V3


@dataclass
class Scene:
    eye: V3 = V3(0, 0, 0)
    look: V3 = V3(0, 0, -1)
    up: V3 = V3(0, 1, 0)
    d: float = -1.0
    bounds: Tuple[float, ...] = (-1, 1, -1, 1)
    res: Tuple[int, ...] = (16, 16)
    ambient: V3 = V3(0, 0, 0)
    lights: List[Light] = field(default_factory=list)
    spheres: List[Sphere] = field(default_factory=list)

    @classmethod
    def load(cls, path: Path) -> Scene:
        scene = cls()
        for line in path.read_text().splitlines():
            words = line.partition("#")[0].split()
            if words:
                handler = getattr(scene, "read_" + words[0], None)
                if handler is None:
                    raise SystemExit(f"don't know what to do with: {line}")
                handler([float(w) for w in words[1:]])
        return scene

    def read_eye(self, n): self.eye = V3(*n)
    def read_look(self, n): self.look = V3(*n)
    def read_up(self, n): self.up = V3(*n)
    def read_d(self, n): self.d = n[0]
    def read_bounds(self, n): self.bounds = tuple(n)
    def read_res(self, n): self.res = tuple(int(x) for x in n)
    def read_ambient(self, n): self.ambient = V3(*n)
    def read_recursionlevel(self, n): pass
    def read_light(self, n): self.lights.append(Light(V3(*n[:3]), n[3], V3(*n[4:7])))

    def read_sphere(self, n):
        self.spheres.append(Sphere(V3(*n[:3]), n[3], V3(*n[4:7]), V3(*n[7:10]), V3(*n[10:13])))

    def rays(self) -> Iterator[Ray]:
        w = (self.eye - self.look).unit()
        u = self.up.cross(w).unit()
        v = w.cross(u)
        left, right, bottom, top = self.bounds
        width, height = self.res
        for j in range(height):
            b = top - j / (height - 1) * (top - bottom)
            for i in range(width):
                a = left + i / (width - 1) * (right - left)
                g = w * self.d + u * a + v * b
                yield Ray(self.eye + g, g.unit())

    def color(self, ray: Ray) -> V3:
        found = [(s, k) for k, sphere in enumerate(self.spheres) if (s := sphere.hit(ray)) is not None]
        if not found:
            return V3(0, 0, 0)
        s, k = min(found)
        ball = self.spheres[k]
        point = ray.at(s)
        normal = (point - ball.center).unit()
        if normal @ ray.way > 0:
            normal = normal * -1
        total = V3(*(a * k for a, k in zip(self.ambient, ball.ka)))
        for light in self.lights:
            to_light = (light.pos - point * light.w).unit()
            lambert = normal @ to_light
            if lambert > 0:
                mirrored = normal * (2 * lambert) - to_light
                phong = max(0.0, -(mirrored @ ray.way)) ** 16
                total += V3(*(e * (kd * lambert + ks * phong) for e, kd, ks in zip(light.rgb, ball.kd, ball.ks)))
        return total


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--driver", type=Path, required=True)
    parser.add_argument("--image", type=Path, required=True)
    args = parser.parse_args()
    scene = Scene.load(args.driver)
    pixels = bytes(min(255, max(0, round(255 * c))) for ray in scene.rays() for c in scene.color(ray))
    args.image.write_bytes(b"P6 %d %d 255\n" % scene.res + pixels)


if __name__ == "__main__":
    main()
