#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MAX 500

typedef struct { double x, y, z; } vec;
typedef struct { vec c; double r; vec ka, kd, ks, kr; double eta, phong; } sphere;
typedef struct { vec pos; double w; vec rgb; } light;

static sphere spheres[MAX];
static light lights[MAX];
static int nspheres, nlights, width, height, level;
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
      light *l = &lights[nlights++];
      ok = sscanf(p, "%lf %lf %lf %lf %lf %lf %lf", &l->pos.x, &l->pos.y, &l->pos.z, &l->w, &l->rgb.x,
                  &l->rgb.y, &l->rgb.z) == 7;
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

static vec color(vec from, vec dir, int depth) {
  double t = 0, t2;
  vec black = {0, 0, 0};
  int l, k = shoot(from, dir, &t);
  if (k < 0) return black;
  sphere *s = &spheres[k];
  vec q = add(from, scale(t, dir)), n = unit(sub(q, s->c)), c = mul(ambient, s->ka);
  vec out = add(q, scale(1e-6, n));
  for (l = 0; l < nlights; l++) {
    vec to = sub(lights[l].pos, q), dirl = unit(to);
    double nl = dot(n, dirl);
    if (nl <= 0 || (shoot(out, dirl, &t2) >= 0 && t2 * t2 < dot(to, to))) continue;
    c = add(c, mul(lights[l].rgb, scale(nl, s->kd)));
    double rv = -dot(dir, sub(scale(2 * nl, n), dirl));
    if (rv > 0) c = add(c, mul(lights[l].rgb, scale(pow(rv, s->phong), s->ks)));
  }
  if (depth > 0) c = add(c, mul(s->kr, color(out, unit(sub(dir, scale(2 * dot(dir, n), n))), depth - 1)));
  return c;
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
      image[(height - 1 - j) * width + i] = color(p, unit(sub(p, eye)), level);
    }
  FILE *f = fopen("out.ppm", "w");
  fprintf(f, "P3\n%d %d\n255\n", width, height);
  for (i = 0; i < width * height; i++)
    fprintf(f, "%d %d %d\n", level255(image[i].x), level255(image[i].y), level255(image[i].z));
  fclose(f);
  free(image);
  return 0;
}
