#!/usr/bin/env bash
# llvmpipe has two conversions to half floats: a picture's truncates, the shader's function rounds.
#
# Guess: a value written to a picture of half floats (GL_RGBA16F) becomes the nearest half float,
# the one that packHalf2x16() gives in the same shader; what is too large becomes infinity.
#
# Happens: packHalf2x16() rounds to nearest. The picture rounds toward zero, always: half of all
# values get the wrong neighbour, and 100000 becomes 65504. Only infinity stays infinite.
#
# With: llvmpipe of Mesa 22.3.6, Debian 12
#
# Software rendering is what tests in continuous integration compare a GPU's HDR pictures with.
source "$(dirname "$0")/common.sh"
needs gcc
debian_packages libgl1-mesa-dri=22.3.6-1* libegl-mesa0=22.3.6-1* libegl-dev libgl-dev
[ ! -d root/usr/lib/x86_64-linux-gnu/dri ] ||
  export LIBGL_DRIVERS_PATH=$folder/root/usr/lib/x86_64-linux-gnu/dri
[ ! -d root/usr/share/glvnd ] ||
  export __EGL_VENDOR_LIBRARY_DIRS=$folder/root/usr/share/glvnd/egl_vendor.d

cat >halves.c <<'C'
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { kSide = 256, kPixels = kSide * kSide };
static float inputs[4 * kPixels], outputs[4 * kPixels];

static void compile(GLuint program, GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, 0);
  glCompileShader(shader);
  glAttachShader(program, shader);
}

// Draws all pixels into a picture of this format: `statement` sets the colour `o` from inputs `p`.
static void draw(const char* statement, GLenum format) {
  char fragment[1000];
  snprintf(fragment, sizeof fragment,
           "#version 450\nuniform sampler2D inputs; out vec4 o;"
           "void main() { vec4 p = texelFetch(inputs, ivec2(gl_FragCoord.xy), 0); %s }", statement);
  const GLuint program = glCreateProgram();
  compile(program, GL_VERTEX_SHADER,
          "#version 450\nvoid main() {"
          "gl_Position = vec4(vec2(gl_VertexID << 1 & 2, gl_VertexID & 2) * 2 - 1, 0, 1); }");
  compile(program, GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(program);
  glUseProgram(program);
  GLuint target, picture;
  glGenFramebuffers(1, &target);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glGenRenderbuffers(1, &picture);
  glBindRenderbuffer(GL_RENDERBUFFER, picture);
  glRenderbufferStorage(GL_RENDERBUFFER, format, kSide, kSide);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, picture);
  glViewport(0, 0, kSide, kSide);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, outputs);
  if (glGetError() != GL_NO_ERROR) exit(2);
}

static void report(const char* name) {
  int wrong = 0, above = 0;
  for (int i = 0; i < kPixels; ++i) {
    wrong += outputs[4 * i] != (float)(_Float16)inputs[4 * i];
    above += outputs[4 * i] > inputs[4 * i];
  }
  printf("%s: %d%% are not the nearest, %d%% are above their value\n", name,
         (100 * wrong + kPixels / 2) / kPixels, (100 * above + kPixels / 2) / kPixels);
}

int main(void) {
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, 0, 0);
  const int any[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  const int version[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
  EGLConfig config;
  int count;
  eglInitialize(display, 0, 0);
  eglBindAPI(EGL_OPENGL_API);
  eglChooseConfig(display, any, &config, 1, &count);
  eglMakeCurrent(display, 0, 0, eglCreateContext(display, config, 0, version));
  const char* renderer = (const char*)glGetString(GL_RENDERER);
  if (!renderer) {
    puts("could not install: Mesa gives no context");
    return 77;
  }
  printf("%.8s\n", renderer);

  srand(2);
  for (int i = 0; i < 4 * kPixels; ++i) inputs[i] = 1 + 99 * (rand() / 2147483648.0);
  GLuint vertices, texture;
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kSide, kSide, 0, GL_RGBA, GL_FLOAT, inputs);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);

  draw("o = vec4(unpackHalf2x16(packHalf2x16(p.xy)), 0, 0);", GL_RGBA32F);
  report("packHalf2x16");
  draw("o = p;", GL_RGBA16F);
  report("GL_RGBA16F");
  draw("o = vec4(65519, 65520, 100000, 1 / (p.x - p.x));", GL_RGBA16F);
  printf("GL_RGBA16F of 65519 65520 100000 inf: %g %g %g %g\n", outputs[0], outputs[1], outputs[2],
         outputs[3]);
}
C
gcc -O1 halves.c -o halves -lEGL -lGL -lm
LIBGL_ALWAYS_SOFTWARE=1 ./halves | tee seen
as_stated <<'SEEN'
llvmpipe
packHalf2x16: 0% are not the nearest, 50% are above their value
GL_RGBA16F: 50% are not the nearest, 0% are above their value
GL_RGBA16F of 65519 65520 100000 inf: 65504 65504 65504 inf
SEEN
