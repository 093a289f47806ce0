"""A finished renderer: rt.py MISTAKE DRIVER IMAGE. It reads a driver file of dialect B and writes a
PPM (P3), the top line first, by ambient light alone; MISTAKE says what is wrong with it."""
import math
import sys

import right

MISTAKE, DRIVER, IMAGE = sys.argv[1:4]


def numbers(words):
    return [float(word) for word in words]


def read():
    view, spheres = {}, []
    for line in open(DRIVER):
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "sphere":
            n = numbers(words[1:])
            spheres.append(((tuple(n[0:3]), n[3]), n[4:7]))
        else:
            view[words[0]] = numbers(words[1:])
    return view, spheres


class Asked:
    tangent, rows, samples, origin, root = "hit", "bottom-first", "edges", "pixel", "nearest"


def nearest(ray, spheres):
    """The first hit's colour."""
    best = None
    for sphere, colour in spheres:
        hit = right.intersect(ray, sphere, Asked)
        if hit is None:
            continue
        if MISTAKE == "first-wins":
            return colour
        if MISTAKE == "last-wins" or best is None or hit[0] < best[0]:
            best = (hit[0], colour)
    return best[1] if best else (0, 0, 0)


def main():
    view, spheres = read()
    width, height = map(int, view["res"])
    left, right_, bottom, top = view["bounds"]
    camera = right.rc.Camera(tuple(view["eye"]), tuple(view["look"]), tuple(view["up"]),
                             view["d"][0], left, right_, bottom, top, width, height)
    asked = Asked()
    asked.samples = "centres" if MISTAKE == "centres" else "edges"
    asked.root = "smaller" if MISTAKE == "near-root-only" else "nearest"
    Asked.root = asked.root
    trace = right.focal_ray if MISTAKE == "focal" else right.pixel_ray
    lines = [[nearest(trace(camera, asked, (i, height - 1 - line)), spheres)
              for i in range(width)] for line in range(height)]
    if MISTAKE == "upside-down":
        lines.reverse()
    if MISTAKE == "mirrored":
        lines = [line[::-1] for line in lines]
    if MISTAKE == "transposed":
        lines = [list(line) for line in zip(*lines)]
    if MISTAKE == "dim":
        lines = [[tuple(0.83 * c for c in colour) for colour in line] for line in lines]
    with open(IMAGE, "w") as image:
        image.write(f"P3\n{len(lines[0])} {len(lines)}\n255\n")
        for line in lines:
            image.write(" ".join(str(min(255, math.floor(255 * c + 0.5)))
                                 for colour in line for c in colour) + "\n")


main()
