// gcc case.c -lctlgeom -lm -o case
#include <ctlgeom.h>
#include <stdio.h>
int main(void) {
  vector3 o = { {ox}, {oy}, {oz} }, d = { {dx}, {dy}, {dz} }, c = { {cx}, {cy}, {cz} };
  double s[2];
  int found = intersect_line_with_object(o, d, make_sphere(0, c, {r}), s);
  double last = found == 2 && s[1] > s[0] ? s[1] : s[0], near = found == 2 && s[1] < s[0] ? s[1] : s[0];
  found && last >= 0 ? printf("%.17g\n", near >= 0 ? near : last) : puts("miss");
}
