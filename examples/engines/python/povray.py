"""POV-Ray (Debian: povray), a complete renderer: povray.py DRIVER IMAGE. Its camera has a location
and a picture plane spanned by `direction`, `right` and `up`; rays go from the location through the
pixels' centres. Objects have only ambient light. Source: POV-Ray's reference, 3.4.2.1 (camera),
3.4.5.3 (sphere), 3.4.7.3 (ambient)."""
import subprocess
import sys

from pictures import combined, read, words


def vector(p):
    return f"<{words(p, ', ')}>"


driver, image = sys.argv[1:]
it = read(driver)
middle = combined((it.near, it.W), ((it.left + it.right) / 2, it.U), ((it.bottom + it.top) / 2, it.V))
with open("case.pov", "w") as file:
    file.write("#version 3.7; global_settings { assumed_gamma 1 ambient_light 1 } "
               f"camera {{ location {vector(it.eye)} direction {vector(middle)} right {vector(combined((it.right - it.left, it.U)))} "
               f"up {vector(combined((it.top - it.bottom, it.V)))} }}\n")
    for x, y, z, radius, *colour in it.spheres:
        file.write(f"sphere {{ {vector([x, y, z])}, {radius:.17g} pigment {{ rgb {vector(colour)} }} "
                   "finish { ambient 1 diffuse 0 } }\n")
asked = ["povray", "+Icase.pov", f"+O{image}", f"+W{it.width}", f"+H{it.height}", "+FP8", "-A", "-D", "-GA", "File_Gamma=1.0", "+WT1"]
done = subprocess.run(asked, capture_output=True, text=True)
sys.exit(done.stderr if done.returncode else 0)
