#!/usr/bin/env bash
# GLM's random numbers leave out the top 1/256 of every range.
#
# Guess: glm::linearRand(0.f, 1.f) is uniform: of 10^8 draws about 390625 are above 255/256, and
# the points of glm::sphericalRand(1.f) have their centre at 0.
#
# Happens: not one of 10^8 draws is above 0.99608. Each byte of the random integer is std::rand() %
# 255, so never 255: every range has gaps at all scales. No point of sphericalRand has a z above
# 0.99216, and their mean z is -0.004.
#
# With: GLM 0.9.9.8, glibc 2.36, Debian 12
#
# Path tracers and tests that draw directions from GLM never look near the pole +z.
source "$(dirname "$0")/common.sh"
needs g++
debian_packages libglm-dev=0.9.9.8+ds-6

cat >draws.cpp <<'CPP'
#include <algorithm>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtc/random.hpp>

int main() {
  float greatest = 0;
  int above = 0;
  for (int i = 0; i < 100000000; ++i) {
    const float x = glm::linearRand(0.f, 1.f);
    greatest = std::max(greatest, x);
    above += x > 255.f / 256;
  }
  std::printf("10^8 draws: %d above 255/256, the greatest is %.5f\n", above, greatest);
  double sum = 0, top = 0, bottom = 0;
  for (int i = 0; i < 10000000; ++i) {
    const double z = glm::sphericalRand(1.f).z;
    sum += z;
    top = std::max(top, z);
    bottom = std::min(bottom, z);
  }
  std::printf("10^7 points of a sphere: z from %.5f to %.5f, mean %.3f\n", bottom, top, sum / 1e7);
}
CPP
g++ -O2 draws.cpp -o draws
./draws | tee seen
as_stated <<'SEEN'
10^8 draws: 0 above 255/256, the greatest is 0.99608
10^7 points of a sphere: z from -1.00000 to 0.99216, mean -0.004
SEEN
