"""POV-Ray (Debian: povray), a complete renderer: povray.py DRIVER IMAGE. Its camera has a location
and a picture plane spanned by `direction`, `right` and `up`; rays go from the location through the
pixels' centres. Objects have only ambient light. Source: POV-Ray's reference, 3.4.2.1 (camera),
3.4.5.3 (sphere), 3.4.7.3 (ambient)."""
import subprocess
import sys


def numbers(words):
    return [float(word) for word in words]


def read(driver):
    view, spheres = {}, []
    for line in open(driver):
        words = line.split("#")[0].split()
        if words[:1] == ["sphere"]:
            spheres.append(numbers(words[1:]))
        elif words:
            view[words[0]] = numbers(words[1:])
    return view, spheres


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def unit(p):
    length = sum(x * x for x in p) ** 0.5
    return [x / length for x in p]


def vector(p):
    return "<" + ", ".join(f"{x:.17g}" for x in p) + ">"


def scene(view, spheres):
    """The scene in its language, with rays through the edges of the picture as in the driver file."""
    eye, look, up, (near,) = view["eye"], view["look"], view["up"], view["d"]
    W = unit([a - b for a, b in zip(eye, look)])
    U = unit(cross(up, W))
    V = cross(W, U)
    left, right, bottom, top = view["bounds"]
    width, height = view["res"]
    across = (right - left) * (width / (width - 1) if width > 1 else 1)
    upwards = (top - bottom) * (height / (height - 1) if height > 1 else 1)
    middle = [near * w + (left + right) / 2 * u + (bottom + top) / 2 * v for w, u, v in zip(W, U, V)]
    text = "#version 3.7; global_settings { assumed_gamma 1 ambient_light 1 } "
    text += (f"camera {{ location {vector(eye)} direction {vector(middle)} right {vector([across * u for u in U])} "
             f"up {vector([upwards * v for v in V])} }}\n")
    for x, y, z, radius, red, green, blue, *_ in spheres:
        text += (f"sphere {{ {vector([x, y, z])}, {radius:.17g} pigment {{ rgb {vector([red, green, blue])} }} "
                 "finish { ambient 1 diffuse 0 } }\n")
    return text


driver, image = sys.argv[1:]
view, spheres = read(driver)
with open("case.pov", "w") as file:
    file.write(scene(view, spheres))
width, height = map(int, view["res"])
asked = ["povray", "+Icase.pov", "+Ocase.png", f"+W{width}", f"+H{height}", "+FN8", "-A", "-D", "-GA", "File_Gamma=1.0", "+WT1"]
done = subprocess.run(asked, capture_output=True, text=True)
if done.returncode != 0:
    sys.exit(done.stderr)
with open("case.png", "rb") as made, open(image, "wb") as file:
    file.write(made.read())
