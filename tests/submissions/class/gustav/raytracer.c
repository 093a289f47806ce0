#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef double vec3[3];

typedef struct {
  vec3 c;
  double r;
  vec3 ka, kd, ks, kr;
} ball_t;

typedef struct {
  vec3 eye, look, up, ambient;
  double d, left, bottom, right, top;
  int w, h, level, nballs, nlights;
  ball_t balls[256];
  double lights[64][7];
} scene_t;

static scene_t sc;

#define FOR3 for (int k = 0; k < 3; k++)

static double dot(const vec3 a, const vec3 b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
static void unit(vec3 a) {
  double n = sqrt(dot(a, a));
  FOR3 a[k] /= n;
}
static void cross(vec3 r, const vec3 a, const vec3 b) {
  FOR3 r[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* reads up to max numbers, returns how many there were */
static int numbers(char *text, double *n, int max) {
  int count = 0;
  for (char *w = strtok(text, " \t\r\n"); w; w = strtok(NULL, " \t\r\n")) {
    if (count < max) n[count] = strtod(w, NULL);
    count++;
  }
  return count;
}

static void fail(const char *what) {
  printf("ERROR: %s\n", what);
  exit(EXIT_FAILURE);
}

static void load(const char *file) {
  char line[1024], key[32];
  double n[32];
  int used;
  FILE *f = fopen(file, "r");
  if (!f) fail("driver file");
  while (fgets(line, sizeof line, f)) {
    if (sscanf(line, "%31s%n", key, &used) != 1) continue;
    int count = numbers(line + used, n, 32);
    if (!strcmp(key, "eye")) FOR3 sc.eye[k] = n[k];
    else if (!strcmp(key, "look")) FOR3 sc.look[k] = n[k];
    else if (!strcmp(key, "up")) FOR3 sc.up[k] = n[k];
    else if (!strcmp(key, "ambient")) FOR3 sc.ambient[k] = n[k];
    else if (!strcmp(key, "d")) sc.d = n[0];
    else if (!strcmp(key, "bounds")) sc.left = n[0], sc.bottom = n[1], sc.right = n[2], sc.top = n[3];
    else if (!strcmp(key, "res")) sc.w = n[0], sc.h = n[1];
    else if (!strcmp(key, "recursionLevel")) sc.level = n[0];
    else if (!strcmp(key, "light")) memcpy(sc.lights[sc.nlights++], n, 7 * sizeof(double));
    else if (!strcmp(key, "sphere")) {
      if (count != 18) fail("sphere line");
      ball_t *b = &sc.balls[sc.nballs++];
      FOR3 b->c[k] = n[k], b->ka[k] = n[4 + k], b->kd[k] = n[7 + k], b->ks[k] = n[10 + k], b->kr[k] = n[13 + k];
      b->r = n[3];
    } else if (strcmp(key, "model")) fail(key);
  }
  fclose(f);
}

static ball_t *closest(const vec3 L, const vec3 U, double *s) {
  ball_t *found = NULL;
  for (ball_t *b = sc.balls; b < sc.balls + sc.nballs; b++) {
    vec3 T;
    FOR3 T[k] = b->c[k] - L[k];
    double v = dot(T, U), csq = dot(T, T), disc = b->r * b->r - (csq - v * v);
    if (disc < 0) continue;
    double d = sqrt(disc), t = v - d;
    if (t < 0) t = v + d;
    if (t >= 0 && (!found || t < *s)) *s = t, found = b;
  }
  return found;
}

static void trace(const vec3 L, const vec3 U, int level, vec3 out) {
  double s, s2;
  vec3 Q, N, off, D, R, more;
  ball_t *b = closest(L, U, &s);
  FOR3 out[k] = 0;
  if (!b) return;
  FOR3 Q[k] = L[k] + s * U[k];
  FOR3 N[k] = (Q[k] - b->c[k]) / b->r;
  FOR3 off[k] = Q[k] + 1e-6 * N[k];
  FOR3 out[k] = sc.ambient[k] * b->ka[k];
  for (int l = 0; l < sc.nlights; l++) {
    FOR3 D[k] = sc.lights[l][k] - Q[k];
    unit(D);
    double nd = dot(N, D);
    if (nd <= 0 || closest(off, D, &s2)) continue;
    FOR3 R[k] = 2 * nd * N[k] - D[k];
    double shine = pow(fmax(0, -dot(R, U) / sqrt(dot(U, U))), 16);
    FOR3 out[k] += sc.lights[l][4 + k] * (b->kd[k] * nd + b->ks[k] * shine);
  }
  if (level > 0) {
    FOR3 R[k] = U[k] - 2 * dot(N, U) * N[k];
    unit(R);
    trace(off, R, level - 1, more);
    FOR3 out[k] += b->kr[k] * more[k];
  }
}

int main(int argc, char **argv) {
  vec3 W, U, V, P, D, c;
  if (argc != 3) fail("two arguments expected");
  load(argv[1]);
  FOR3 W[k] = sc.eye[k] - sc.look[k];
  unit(W);
  cross(U, sc.up, W);
  unit(U);
  cross(V, W, U);
  FILE *f = fopen(argv[2], "wb");
  fprintf(f, "P6 %d %d 255\n", sc.w, sc.h);
  for (int j = sc.h - 1; j >= 0; j--)
    for (int i = 0; i < sc.w; i++) {
      double x = i / (sc.w - 1.0) * (sc.right - sc.left) + sc.left;
      double y = j / (sc.h - 1.0) * (sc.top - sc.bottom) + sc.bottom;
      FOR3 P[k] = sc.eye[k] - sc.d * W[k] + x * U[k] + y * V[k];
      FOR3 D[k] = P[k] - sc.eye[k];
      trace(P, D, sc.level, c);
      FOR3 putc((int)(255 * fmin(1, c[k])), f);
    }
  fclose(f);
}
