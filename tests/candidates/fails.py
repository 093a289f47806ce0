"""A candidate that is right, but fails on some questions: fails.py HOW WHERE.

HOW is exit, abort, hang, error (an error reply), garbage (a line with words missing) or once (it exits at
its 100th question). WHERE is one (the ray of pixel (11, 7) of ten-spheres.toml and
its sphere 2), lower (every ray whose direction points down), made (making the ray
of pixel (5, 7)), or all.
"""
import os
import sys
import time

import raycheck_candidate as rc
import right

how, where = sys.argv[1:3]
asked_so_far = 0


def fail():
    if how == "exit":
        os._exit(3)
    if how == "abort":
        os.abort()
    if how == "hang":
        time.sleep(1000)
    if how == "error":
        raise ValueError("this one is too hard")


def is_guilty(ray, sphere):
    global asked_so_far
    asked_so_far += 1
    if how == "once":
        return asked_so_far == 100
    (_, d), (centre, r) = ray, sphere
    if where == "one":
        return centre[0] == 26 and 0.296 < d[0] < 0.297 and -0.043 < d[1] < -0.042
    return where == "all" or (where == "lower" and d[1] < 0)


def intersect(ray, sphere, asked):
    if is_guilty(ray, sphere):
        if how == "once":
            os._exit(3)
        fail()
        return 1.0, (1.0, 2.0)
    return right.intersect(ray, sphere, asked)


def pixel_ray(camera, asked, pixel):
    if where == "made" and pixel == (5, 7):
        fail()
        return (0.0, 0.0), (1.0, 0.0)
    return right.pixel_ray(camera, asked, pixel)


rc.run("fails", pixel_ray=pixel_ray, intersect=intersect)
