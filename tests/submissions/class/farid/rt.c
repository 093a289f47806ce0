#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX 500

typedef struct { double x, y, z; } vec;
typedef struct { vec c; double r; vec ka, kd, ks, kr; double eta, phong; } sphere;

static sphere spheres[MAX];
static int nspheres, width, height, level;
static vec eye, look, up, ambient;
static double d, left, bottom, right, top;

static vec add(vec a, vec b) { vec r = {a.x + b.x, a.y + b.y, a.z + b.z}; return r; }
static vec sub(vec a, vec b) { vec r = {a.x - b.x, a.y - b.y, a.z - b.z}; return r; }
static vec mul(vec a, vec b) { vec r = {a.x * b.x, a.y * b.y, a.z * b.z}; return r; }
static vec scale(double k, vec a) { vec r = {k * a.x, k * a.y, k * a.z}; return r; }
static double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec unit(vec a) { return scale(1 / sqrt(dot(a, a)), a); }
static vec cross(vec a, vec b) {
  vec r = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return r;
}

static void die(const char *line) {
  fprintf(stderr, "rt: cannot read: %s\n", line);
  exit(2);
}

static void parse(const char *name) {
  char line[1000], key[50];
  FILE *f = fopen(name, "r");
  if (!f) die(name);
  while (fgets(line, sizeof line, f)) {
    int n = 0;
    if (sscanf(line, "%49s%n", key, &n) != 1) continue;
    const char *p = line + n;
    int ok = 1;
    if (key[0] == '#') continue;
    if (!strcmp(key, "eye")) ok = sscanf(p, "%lf %lf %lf", &eye.x, &eye.y, &eye.z) == 3;
    else if (!strcmp(key, "look")) ok = sscanf(p, "%lf %lf %lf", &look.x, &look.y, &look.z) == 3;
    else if (!strcmp(key, "up")) ok = sscanf(p, "%lf %lf %lf", &up.x, &up.y, &up.z) == 3;
    else if (!strcmp(key, "d")) ok = sscanf(p, "%lf", &d) == 1;
    else if (!strcmp(key, "bounds")) ok = sscanf(p, "%lf %lf %lf %lf", &left, &bottom, &right, &top) == 4;
    else if (!strcmp(key, "res")) ok = sscanf(p, "%d %d", &width, &height) == 2;
    else if (!strcmp(key, "recursionLevel")) ok = sscanf(p, "%d", &level) == 1;
    else if (!strcmp(key, "ambient")) ok = sscanf(p, "%lf %lf %lf", &ambient.x, &ambient.y, &ambient.z) == 3;
    else if (!strcmp(key, "light")) {
      double l[7];
      ok = sscanf(p, "%lf %lf %lf %lf %lf %lf %lf", l, l + 1, l + 2, l + 3, l + 4, l + 5, l + 6) == 7;
    } else if (!strcmp(key, "sphere")) {
      sphere *s = &spheres[nspheres++];
      ok = sscanf(p, "%lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf %lf", &s->c.x,
                  &s->c.y, &s->c.z, &s->r, &s->ka.x, &s->ka.y, &s->ka.z, &s->kd.x, &s->kd.y, &s->kd.z,
                  &s->ks.x, &s->ks.y, &s->ks.z, &s->kr.x, &s->kr.y, &s->kr.z, &s->eta, &s->phong) == 18;
    } else ok = 0;
    if (!ok) die(line);
  }
  fclose(f);
}

/* index of the first sphere along the ray, or -1 */
static int shoot(vec from, vec dir, double *t) {
  int k, found = -1;
  for (k = 0; k < nspheres; k++) {
    vec T = sub(spheres[k].c, from);
    double v = dot(T, dir), c2 = dot(T, T), r = spheres[k].r;
    double d2 = r * r - (c2 - v * v), s;
    if (d2 < 0) continue;
    s = v - sqrt(d2);
    if (s < 0) s = v + sqrt(d2);
    if (s >= 0 && (found < 0 || s < *t)) {
      *t = s;
      found = k;
    }
  }
  return found;
}

static vec color(vec from, vec dir) {
  double t = 0;
  vec black = {0, 0, 0};
  int k = shoot(from, dir, &t);
  return k < 0 ? black : mul(ambient, spheres[k].ka);
}

static int level255(double x) { return x >= 1 ? 255 : (int)(x * 255); }

int main(int argc, char **argv) {
  int i, j;
  if (argc < 2) die("(no driver file)");
  parse(argv[1]);
  vec w = unit(sub(eye, look)), u = unit(cross(up, w)), v = cross(w, u);
  vec *image = malloc(sizeof(vec) * width * height);
  for (i = 0; i < width; i++)
    for (j = 0; j < height; j++) {
      double px = left + (double)i / (width - 1) * (right - left);
      double py = bottom + (double)j / (height - 1) * (top - bottom);
      vec p = add(add(add(eye, scale(-d, w)), scale(px, u)), scale(py, v));
      image[(height - 1 - j) * width + i] = color(p, unit(sub(p, eye)));
    }
  FILE *f = fopen("out.ppm", "w");
  fprintf(f, "P3\n%d %d\n255\n", width, height);
  for (i = 0; i < width * height; i++)
    fprintf(f, "%d %d %d\n", level255(image[i].x), level255(image[i].y), level255(image[i].z));
  fclose(f);
  free(image);
  return 0;
}
