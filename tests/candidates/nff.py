"""A renderer of balls in files of the Neutral File Format: nff.py [half-angle] SCENE.nff IMAGE.ppm"""

import math
import sys


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(v):
    return [x / math.sqrt(dot(v, v)) for x in v]


mistake, scene, image = ([""] + sys.argv[1:])[-3:]
camera, balls, colour = {}, [], None
for line in open(scene):
    keyword, *words = line.split()
    if keyword == "f":
        colour = [float(x) for x in words[:3]]
    elif keyword == "s":
        balls.append(([float(x) for x in words[:3]], float(words[3]), colour))
    else:
        camera[keyword] = [float(x) for x in words]
eye, (width, height) = camera["from"], [int(n) for n in camera["resolution"]]
towards = unit([a - b for a, b in zip(camera["at"], eye)])
right = unit(cross(towards, camera["up"]))
up = cross(right, towards)
top = math.tan(math.radians(camera["angle"][0]) / (1 if mistake == "half-angle" else 2))
pixels = []
for j in range(height):
    for i in range(width):
        x, y = (2 * (i + 0.5) / width - 1) * top * width / height, (1 - 2 * (j + 0.5) / height) * top
        ray = unit([t + x * r + y * u for t, r, u in zip(towards, right, up)])
        nearest, shown = math.inf, [0, 0, 0]
        for centre, radius, colour in balls:
            to = [c - e for c, e in zip(centre, eye)]
            v, off = dot(to, ray), cross(to, ray)
            under = radius * radius - dot(off, off)
            if under < 0:
                continue
            s = v - math.sqrt(under) if v >= math.sqrt(under) else v + math.sqrt(under)
            if 0 <= s < nearest:
                nearest, shown = s, colour
        pixels.append(" ".join(str(round(255 * c)) for c in shown))
with open(image, "w") as out:
    print("P3", width, height, 255, *pixels, sep="\n", file=out)
