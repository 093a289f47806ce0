"""A function in GLSL, run by OpenGL: python3 glsl.py FILE.glsl. A compute shader calls it for all
rays and one sphere, in floats. Without a display and a GPU, Mesa's llvmpipe runs it (Debian:
python3-moderngl, libgl1-mesa-dri, libegl1). A GPU's driver may round differently, since GLSL allows
errors of some ulp in divisions and roots.
"""
import os
import pathlib
import struct
import sys

import raycheck_candidate as rc
import shader

os.environ.setdefault("LP_NUM_THREADS", "0")  # run llvmpipe in this thread only
os.environ.setdefault("MESA_SHADER_CACHE_DISABLE", "true")
import moderngl  # noqa: E402  (after its environment is set)

_MAIN = """
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Rays { float rays[]; };
layout(std430, binding = 1) writeonly buffer Answers { float answers[]; };
uniform vec3 centre;
uniform float radius;
void main() {
  uint k = gl_GlobalInvocationID.x;
  if (k >= answers.length()) return;
  vec3 o = vec3(rays[6 * k], rays[6 * k + 1], rays[6 * k + 2]);
  vec3 d = vec3(rays[6 * k + 3], rays[6 * k + 4], rays[6 * k + 5]);
  answers[k] = hit_sphere(o, d, centre, radius);
}
"""


def main(file):
    source, declared = shader.read(file)
    context = moderngl.create_context(standalone=True, backend="egl", require=430)
    program = context.compute_shader("#version 430\n" + source + _MAIN)

    def intersect_batch(rays, sphere, _):
        for name, value in zip(("centre", "radius"), sphere):
            if name in program:  # a shader that does not use an input has none
                program[name] = value
        given = context.buffer(struct.pack(f"{6 * len(rays)}f", *shader.flat(rays)))
        answers = context.buffer(reserve=4 * len(rays))
        given.bind_to_storage_buffer(0)
        answers.bind_to_storage_buffer(1)
        program.run((len(rays) + 63) // 64)
        context.finish()
        found = struct.unpack(f"{len(rays)}f", answers.read())
        given.release()
        answers.release()
        return shader.hits(found)

    rc.run(pathlib.Path(file).stem + "-glsl", intersect_batch=intersect_batch, **declared)


main(sys.argv[1])
