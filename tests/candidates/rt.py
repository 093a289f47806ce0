"""A finished renderer: rt.py MISTAKE DRIVER IMAGE [OPTIONS]. It reads a driver file of dialect B (C
and A for some MISTAKEs) and writes a PPM (P3) or what written.py writes, by the ending of IMAGE, with
ambient light only; if MISTAKE begins with depth, a depth picture (PFM). MISTAKE selects a mistake; OPTIONS are of the format."""
import math
import os
import struct
import sys
import time
import zlib

import right
import written

MISTAKE, DRIVER, IMAGE, *OPTIONS = sys.argv[1:]


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
    """The first hit's s and colour."""
    best = None
    for sphere, colour in spheres:
        hit = right.intersect(ray, sphere, Asked)
        if MISTAKE == "lines":  # spheres behind the origin, too
            behind = right.intersect((ray[0], tuple(-x for x in ray[1])), sphere, Asked)
            hit = (-behind[0],) if behind else hit
        if hit is None:
            continue
        if MISTAKE == "threshold" and hit[0] < 0.5:
            continue
        if best is None or hit[0] < best[0]:
            best = (hit[0], colour)
    return best


def colour(ray, spheres):
    best = nearest(ray, spheres)
    return best[1] if best else (0, 0, 0)


def depth(camera, pixel, spheres):
    """The distance of the first hit from the eye, or what MISTAKE says."""
    _, kind, *miss = MISTAKE.split(":")
    ray = right.pixel_ray(camera, Asked, pixel)
    best = nearest(ray, spheres)
    if best is None:
        return float(miss[0]) if miss else math.inf
    if kind == "constant":
        return 7.0
    s, length = best[0], math.hypot(*right.sight(camera, Asked, pixel))
    return {"s": s, "z": (s + length) * -camera.near / length, "image-plane": (s + length) / length,
            "off": (s + length) * (1 + 2e-5)}.get(kind, s + length)


def main():
    view, spheres = read()
    width, height = map(int, view["res"])
    left, right_, bottom, top = view["bounds"]
    whole = view["camera"] if MISTAKE == "dialect-c" else (
        view["eye"] + view["look"] + view["up"] + view["d"])
    eye, look, up, near = tuple(whole[0:3]), tuple(whole[3:6]), tuple(whole[6:9]), whole[9]
    if MISTAKE == "dialect-a":
        bottom, right_, near = right_, bottom, -near
    camera = right.rc.Camera(eye, look, up, near, left, right_, bottom, top, width, height)
    if MISTAKE == "near-root-only":
        Asked.root = "smaller"
    if MISTAKE == "depth:far-root":
        right.MISTAKE = "far_root"
    if MISTAKE == "depth:half-pixel":
        Asked.samples = "centres"
    if MISTAKE.startswith("depth"):
        numbers_ = [depth(camera, (i, j), spheres) for j in range(height) for i in range(width)]
        with open(IMAGE, "wb") as image:
            image.write(b"Pf\n%d %d\n-1.0\n" % (width, height) + struct.pack(f"<{len(numbers_)}f", *numbers_))
        return
    if MISTAKE in ("corners", "centres"):
        Asked.samples = MISTAKE
    ray = right.focal_ray if MISTAKE == "from-eye" else right.pixel_ray
    lines = [[colour(ray(camera, Asked, (i, height - 1 - line)), spheres)
              for i in range(width)] for line in range(height)]
    if MISTAKE in ("upside-down", "dim-upside-down"):
        lines.reverse()
    if MISTAKE == "mirrored":
        lines = [line[::-1] for line in lines]
    if MISTAKE == "transposed":
        lines = [list(line) for line in zip(*lines)]
    if MISTAKE == "grey":
        lines = [[(0.5, 0.5, 0.5) if any(colour) else colour for colour in line] for line in lines]
    if MISTAKE.startswith("dim"):
        lines = [[tuple(0.83 * c for c in colour) for colour in line] for line in lines]
    if MISTAKE == "no-picture":
        return
    if MISTAKE == "huge":
        chunks = {b"IHDR": struct.pack(">IIBBBBB", 8192, 8192, 8, 2, 0, 0, 0), b"IDAT": b"x"}
        with open(IMAGE, "wb") as image:
            image.write(b"\x89PNG\r\n\x1a\n")
            for name, data in chunks.items():
                checked = name + data
                image.write(struct.pack(">I", len(data)) + checked)
                image.write(struct.pack(">I", zlib.crc32(checked)))
        return
    if MISTAKE == "crash":
        sys.exit(1)
    if MISTAKE == "hang":
        time.sleep(1000)
    if MISTAKE == "link":
        os.symlink("/etc/passwd", IMAGE)
        return
    if MISTAKE == "half":
        lines = [lines[0]] + [[] for _ in lines[1:]]
    lines = [[tuple(min(255, math.floor(255 * c + 0.5)) for c in colour) for colour in line] for line in lines]
    if not IMAGE.endswith(".ppm"):
        written.write(lines, IMAGE, *OPTIONS)
        return
    with open(IMAGE, "w") as image:
        image.write(f"P3\n{len(lines[0])} {len(lines)}\n255\n")
        for line in lines:
            image.write(" ".join(str(c) for colour in line for c in colour) + "\n")


main()
