// gcc case.c -lmujoco -o case
#include <mujoco/mujoco.h>
#include <stdio.h>
int main(void) {
  mjtNum pos[3] = { {cx}, {cy}, {cz} }, mat[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, size[3] = { {r} };
  mjtNum pnt[3] = { {ox}, {oy}, {oz} }, vec[3] = { {dx}, {dy}, {dz} };
  mjtNum x = mju_rayGeom(pos, mat, size, pnt, vec, mjGEOM_SPHERE);
  x != -1 ? printf("%.17g\n", x) : puts("miss");
}
