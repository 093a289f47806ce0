/* gcc case.c -lmujoco -lm -o case */
#include <mujoco/mujoco.h>
#include <stdio.h>
int main(void) {
  FILE* file = fopen("ball.xml", "w");
  fputs("<mujoco><worldbody><geom type='sphere' pos='{cx} {cy} {cz}' size='{r}'/></worldbody></mujoco>", file);
  fclose(file);
  mjModel* model = mj_loadXML("ball.xml", NULL, NULL, 0);
  mjData* data = mj_makeData(model);
  mj_forward(model, data);
  mjtNum up[3] = {{ux}, {uy}, {uz}}, forward[3] = {{ax} - {ex}, {ay} - {ey}, {az} - {ez}}, right[3], above[3], p[3];
  mju_normalize3(forward);
  mju_cross(right, forward, up);
  mju_normalize3(right);
  mju_cross(above, right, forward);
  mjvScene scene;
  mjv_defaultScene(&scene);
  scene.camera[0] = scene.camera[1] = (mjvGLCamera){{{ex}, {ey}, {ez}}, {forward[0], forward[1], forward[2]},
      {above[0], above[1], above[2]}, 0, {bottom}, {top}, {near}, 1000 * {near}};
  scene.scale = 1;
  mjvOption options;
  mjv_defaultOption(&options);
  int geom = -1, skin = -1;
  if (mjv_select(model, data, &options, {right} / {top}, ({i} + 0.5) / {width}, ({j} + 0.5) / {height}, &scene, p, &geom, &skin) < 0)
    puts("miss");
  else
    printf("%.17g %.17g %.17g\n", p[0], p[1], p[2]);
}
