"""Tachyon (Debian: tachyon), a complete renderer: tachyon.py DRIVER IMAGE [SHIFT]. Its system of coordinates is left-handed: z
changes its sign. SHIFT moves the picture by this part of a pixel. Source: docs/camera.tex, docs/objects.tex, docs/texture.tex."""
import subprocess
import sys

from pictures import combined, read, words

driver, image, *shift = sys.argv[1:]
it = read(driver)
mirrored = lambda p: words([p[0], p[1], -p[2]])
ahead = it.near < 0
x, y = ((float(shift[0]) if shift else 0) * (high - low) / count for low, high, count in
        ((it.left, it.right, it.width), (it.bottom, it.top, it.height)))
sides = [it.left + x, it.right + x] if ahead else [-it.left - x, -it.right - x]
frustum = [side / abs(it.near) for side in [*sides, it.bottom + y, it.top + y]]
with open("case.dat", "w") as file:
    file.write(f"BEGIN_SCENE\nRESOLUTION {it.width} {it.height}\nCAMERA\nZOOM 1\nASPECTRATIO 1\nANTIALIASING 0\nRAYDEPTH 1\n"
               f"CENTER {mirrored(it.eye)}\nVIEWDIR {mirrored(combined((-1 if ahead else 1, it.W)))}\nUPDIR {mirrored(it.V)}\n"
               f"FRUSTUM {words(frustum)}\nEND_CAMERA\nBACKGROUND 0 0 0\n")
    for x, y, z, radius, *colour in it.spheres:
        file.write(f"SPHERE CENTER {mirrored([x, y, z])} RAD {radius:.17g} TEXTURE AMBIENT 1 DIFFUSE 0 SPECULAR 0 OPACITY 1 "
                   f"COLOR {words(colour)} TEXFUNC 0\n")
    file.write("END_SCENE\n")
done = subprocess.run(["tachyon", "case.dat", "-numthreads", "1", "-nobounding", "-format", "PPM", "-o", image], capture_output=True, text=True)
sys.exit(done.stdout + done.stderr if done.returncode else 0)
