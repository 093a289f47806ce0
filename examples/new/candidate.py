"""NAME, a candidate for raycheck: call your function below, and declare its conventions at the end."""
import raycheck_candidate as rc


def intersect(ray, sphere, conventions):
    (origin, direction), (centre, radius) = ray, sphere
    # Return None for a miss, or (s, point) with the point at origin + s direction.
    raise NotImplementedError("NAME: calls nothing yet")


# root="smaller" is always v - d. Add what applies to your code: precision="single" if it computes
# in floats; roots=rc.Roots("()", 1e-3, float("inf"), "length", "none") if it ignores hits nearer
# than 1e-3; directions="unit" if it requires unit directions; returns="parameter", "point",
# "distance", "squared-distance", "class" (it declares its root, too) or
# "roots".
rc.run("NAME", root="nearest", tangent="either", intersect=intersect)
