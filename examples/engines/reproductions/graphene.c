// gcc case.c $(pkg-config --cflags --libs graphene-1.0) -o case
#include <graphene.h>
#include <stdio.h>
int main(void) {
  graphene_ray_t ray;
  graphene_sphere_t sphere;
  graphene_vec3_t direction;
  float s = 0;
  graphene_vec3_init(&direction, {dx}, {dy}, {dz});
  graphene_ray_init(&ray, &(graphene_point3d_t){ {ox}, {oy}, {oz} }, &direction);
  graphene_sphere_init(&sphere, &(graphene_point3d_t){ {cx}, {cy}, {cz} }, {r});
  graphene_ray_intersect_sphere(&ray, &sphere, &s) ? printf("%.9g\n", s) : puts("miss");
}
