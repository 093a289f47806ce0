/* MuJoCo's mjv_select: the point of a geom under the mouse, at (relx, rely) of the window, here of
   a sphere, the only geom of the world. The camera of a scene, mjvGLCamera, is in floats: its
   position, two of its axes and its frustum. Debian: libmujoco-dev; -lmujoco.
   Source: mujoco/mujoco.h, "Select geom or skin with mouse", mjvisualize.h. Silent on tangents and
   on errors; rays start at the camera's position. */

#include <math.h>
#include <mujoco/mujoco.h>
#include <raycheck/candidate.h>
#include <stdlib.h>
#include <string.h>

static mjModel* load(void) {
  static const char text[] =
      "<mujoco><worldbody><geom type='sphere' size='1'/></worldbody></mujoco>";
  mjVFS* const files = malloc(sizeof *files);
  char error[256];
  mjModel* model;
  mj_defaultVFS(files);
  mj_makeEmptyFileVFS(files, "ball.xml", sizeof text - 1);
  memcpy(files->filedata[0], text, sizeof text - 1);
  model = mj_loadXML("ball.xml", files, error, sizeof error);
  free(files);
  return model;
}

static void set(float to[3], const mjtNum from[3]) {
  for (int k = 0; k < 3; ++k) to[k] = (float)from[k];
}

static raycheck_hit pick(const raycheck_camera* camera, const raycheck_conventions* asked,
                         raycheck_pixel pixel, const raycheck_sphere* sphere) {
  static mjModel* model;
  static mjData* data;
  const raycheck_vector e = camera->eye, a = camera->look_at, u = camera->up, c = sphere->centre;
  const mjtNum eye[3] = {e.x, e.y, e.z}, up[3] = {u.x, u.y, u.z};
  mjtNum forward[3] = {a.x - e.x, a.y - e.y, a.z - e.z}, right[3], above[3], found[3];
  mjvGLCamera own = {.frustum_bottom = (float)camera->bottom,
                     .frustum_top = (float)camera->top,
                     .frustum_near = (float)-camera->near_plane,
                     .frustum_far = (float)(-1000 * camera->near_plane)};
  mjvScene scene;
  mjvOption options;
  int geom = -1, skin = -1;
  raycheck_hit hit = {0, 0, {0, 0, 0}};
  (void)asked;
  if (model == NULL) {
    model = load();
    data = mj_makeData(model);
    mj_forward(model, data);
  }
  model->geom_size[0] = model->geom_rbound[0] = sphere->radius;
  data->geom_xpos[0] = c.x, data->geom_xpos[1] = c.y, data->geom_xpos[2] = c.z;
  mju_normalize3(forward);
  mju_cross(right, forward, up);
  mju_normalize3(right);
  mju_cross(above, right, forward);
  set(own.pos, eye);
  set(own.forward, forward);
  set(own.up, above);
  mjv_defaultOption(&options);
  mjv_defaultScene(&scene);
  scene.camera[0] = scene.camera[1] = own;
  scene.scale = 1;
  hit.hit = mjv_select(model, data, &options, camera->right / camera->top,
                       ((double)pixel.i + 0.5) / (double)camera->width,
                       ((double)pixel.j + 0.5) / (double)camera->height, &scene, found, &geom,
                       &skin) >= 0;
  hit.point = (raycheck_vector){found[0], found[1], found[2]};
  return hit;
}

const raycheck_candidate* raycheck_candidate_functions(void) {
  static raycheck_candidate candidate;
  candidate.version = RAYCHECK_CANDIDATE_VERSION;
  candidate.declared.rows = RAYCHECK_ROWS_BOTTOM_FIRST;
  candidate.declared.samples = RAYCHECK_SAMPLES_CENTRES;
  candidate.declared.origin = RAYCHECK_ORIGIN_FOCAL;
  candidate.declared.root = RAYCHECK_ROOT_NEAREST;
  candidate.declared.tangent = RAYCHECK_TANGENT_EITHER;
  candidate.level = RAYCHECK_LEVEL_ORDINARY;
  candidate.smallest_length = 0x1p-30;
  candidate.largest_length = 0x1p30;
  candidate.precision = RAYCHECK_PRECISION_SINGLE;
  candidate.returns = RAYCHECK_RETURNS_POINT;
  candidate.contract = "windows symmetric";
  candidate.pick = pick;
  return &candidate;
}
