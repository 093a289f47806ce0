/* gcc -O2 -o pa2 pa2.c -lm */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct sphere { double c[3], r, ka[3], kd[3], ks[3], kr[3]; };

struct sphere spheres[200];
double lights[50][6];
int n_spheres = 0, n_lights = 0, width, height, levels = 0;
double eye[3], look[3], up[3], amb[3], d, left, bottom, right, top;

double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
void sub(double *r, const double *a, const double *b) { for (int k = 0; k < 3; k++) r[k] = a[k] - b[k]; }
void madd(double *r, const double *a, double t, const double *b) { for (int k = 0; k < 3; k++) r[k] = a[k] + t * b[k]; }
void normalize(double *a) {
  double n = sqrt(dot(a, a));
  for (int k = 0; k < 3; k++) a[k] /= n;
}
void cross(double *r, const double *a, const double *b) {
  r[0] = a[1] * b[2] - a[2] * b[1];
  r[1] = a[2] * b[0] - a[0] * b[2];
  r[2] = a[0] * b[1] - a[1] * b[0];
}

/* next word of the line as a coordinate, as a color */
double coord(void) {
  char *w = strtok(NULL, " \t\r\n");
  if (!w) exit(1);
  return atoi(w);
}
double shade01(void) {
  char *w = strtok(NULL, " \t\r\n");
  if (!w) exit(1);
  return atof(w);
}

void read_driver(const char *name) {
  char line[512];
  FILE *in = fopen(name, "r");
  if (!in) { perror(name); exit(1); }
  while (fgets(line, sizeof line, in)) {
    char *key = strtok(line, " \t\r\n");
    int k;
    if (!key || *key == '#') continue;
    if (!strcmp(key, "eye")) for (k = 0; k < 3; k++) eye[k] = coord();
    else if (!strcmp(key, "look")) for (k = 0; k < 3; k++) look[k] = coord();
    else if (!strcmp(key, "up")) for (k = 0; k < 3; k++) up[k] = coord();
    else if (!strcmp(key, "d")) d = coord();
    else if (!strcmp(key, "bounds")) { left = coord(); bottom = coord(); right = coord(); top = coord(); }
    else if (!strcmp(key, "res")) { width = coord(); height = coord(); }
    else if (!strcmp(key, "recursionLevel")) levels = coord();
    else if (!strcmp(key, "ambient")) for (k = 0; k < 3; k++) amb[k] = shade01();
    else if (!strcmp(key, "light")) {
      for (k = 0; k < 3; k++) lights[n_lights][k] = coord();
      coord();
      for (k = 3; k < 6; k++) lights[n_lights][k] = shade01();
      n_lights++;
    } else if (!strcmp(key, "sphere")) {
      struct sphere *s = &spheres[n_spheres++];
      for (k = 0; k < 3; k++) s->c[k] = coord();
      s->r = coord();
      for (k = 0; k < 3; k++) s->ka[k] = shade01();
      for (k = 0; k < 3; k++) s->kd[k] = shade01();
      for (k = 0; k < 3; k++) s->ks[k] = shade01();
      for (k = 0; k < 3; k++) s->kr[k] = shade01();
    }
  }
  fclose(in);
}

struct sphere *first(const double *p, const double *dir, double *t) {
  struct sphere *found = NULL;
  for (int k = 0; k < n_spheres; k++) {
    double to[3];
    sub(to, spheres[k].c, p);
    double v = dot(to, dir), dsq = spheres[k].r * spheres[k].r - dot(to, to) + v * v;
    if (dsq < 0) continue;
    double s = v - sqrt(dsq);
    if (s < 0) s = v + sqrt(dsq);
    if (s < 0 || (found && s >= *t)) continue;
    *t = s;
    found = &spheres[k];
  }
  return found;
}

void shade(double *rgb, const double *p, const double *dir, int level) {
  double t = 0, q[3], n[3], l[3], r[3], more[3], t2;
  struct sphere *s = first(p, dir, &t);
  rgb[0] = rgb[1] = rgb[2] = 0;
  if (!s) return;
  madd(q, p, t, dir);
  sub(n, q, s->c);
  normalize(n);
  madd(more, q, 1e-6, n);
  for (int k = 0; k < 3; k++) rgb[k] = amb[k] * s->ka[k];
  for (int m = 0; m < n_lights; m++) {
    sub(l, lights[m], q);
    normalize(l);
    double nl = dot(n, l);
    if (nl <= 0 || first(more, l, &t2)) continue;
    for (int k = 0; k < 3; k++) r[k] = 2 * nl * n[k] - l[k];
    double rv = dot(r, dir) < 0 ? pow(-dot(r, dir), 16) : 0;
    for (int k = 0; k < 3; k++) rgb[k] += lights[m][3 + k] * (s->kd[k] * nl + s->ks[k] * rv);
  }
  if (level > 0) {
    double c[3];
    madd(r, dir, -2 * dot(n, dir), n);
    normalize(r);
    shade(c, more, r, level - 1);
    for (int k = 0; k < 3; k++) rgb[k] += s->kr[k] * c[k];
  }
}

int main(int argc, char **argv) {
  double w[3], u[3], v[3], p[3], dir[3], rgb[3];
  if (argc != 3) return 1;
  read_driver(argv[1]);
  sub(w, eye, look);
  normalize(w);
  cross(u, up, w);
  normalize(u);
  cross(v, w, u);
  FILE *out = fopen(argv[2], "w");
  fprintf(out, "P3\n%d %d\n255\n", width, height);
  for (int j = 0; j < height; j++, fprintf(out, "\n"))
    for (int i = 0; i < width; i++) {
      madd(p, eye, -d, w);
      madd(p, p, left + (right - left) * i / (width - 1), u);
      madd(p, p, top - (top - bottom) * j / (height - 1), v);
      sub(dir, p, eye);
      normalize(dir);
      shade(rgb, p, dir, levels);
      for (int k = 0; k < 3; k++) fprintf(out, "%d ", rgb[k] < 1 ? (int)(rgb[k] * 255 + .5) : 255);
    }
  fclose(out);
  return 0;
}
