#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "scene.h"

vec add(vec a, vec b) { vec c = {a.x + b.x, a.y + b.y, a.z + b.z}; return c; }
vec sub(vec a, vec b) { vec c = {a.x - b.x, a.y - b.y, a.z - b.z}; return c; }
vec scale(double k, vec a) { vec c = {k * a.x, k * a.y, k * a.z}; return c; }
double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
vec unit(vec a) { return scale(1 / sqrt(dot(a, a)), a); }
vec cross(vec a, vec b)
{
    vec c = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return c;
}

int read_scene(const char *path, scene *sc)
{
    char line[512];
    FILE *in = fopen(path, "r");
    if (in == NULL)
        return 0;
    memset(sc, 0, sizeof *sc);
    while (fgets(line, sizeof line, in) != NULL) {
        char key[32];
        int used;
        const char *rest;
        if (sscanf(line, "%31s%n", key, &used) != 1)
            continue;
        rest = line + used;
        if (strcmp(key, "eye") == 0)
            sscanf(rest, "%lf%lf%lf", &sc->eye.x, &sc->eye.y, &sc->eye.z);
        else if (strcmp(key, "look") == 0)
            sscanf(rest, "%lf%lf%lf", &sc->look.x, &sc->look.y, &sc->look.z);
        else if (strcmp(key, "up") == 0)
            sscanf(rest, "%lf%lf%lf", &sc->up.x, &sc->up.y, &sc->up.z);
        else if (strcmp(key, "d") == 0)
            sscanf(rest, "%lf", &sc->d);
        else if (strcmp(key, "bounds") == 0)
            sscanf(rest, "%lf%lf%lf%lf", &sc->left, &sc->right, &sc->bottom, &sc->top);
        else if (strcmp(key, "res") == 0)
            sscanf(rest, "%d%d", &sc->cols, &sc->rows);
        else if (strcmp(key, "ambient") == 0)
            sscanf(rest, "%lf%lf%lf", &sc->ambient.x, &sc->ambient.y, &sc->ambient.z);
        else if (strcmp(key, "light") == 0) {
            light *l;
            sc->lights = realloc(sc->lights, (sc->nlights + 1) * sizeof(light));
            l = &sc->lights[sc->nlights++];
            sscanf(rest, "%lf%lf%lf%lf%lf%lf%lf", &l->pos.x, &l->pos.y, &l->pos.z, &l->w,
                   &l->rgb.x, &l->rgb.y, &l->rgb.z);
        } else if (strcmp(key, "sphere") == 0) {
            sphere *s;
            sc->spheres = realloc(sc->spheres, (sc->nspheres + 1) * sizeof(sphere));
            s = &sc->spheres[sc->nspheres++];
            if (sscanf(rest, "%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf%lf",
                       &s->centre.x, &s->centre.y, &s->centre.z, &s->radius,
                       &s->ka.x, &s->ka.y, &s->ka.z, &s->kd.x, &s->kd.y, &s->kd.z,
                       &s->ks.x, &s->ks.y, &s->ks.z) != 13)
                return 0;
        }
    }
    fclose(in);
    return 1;
}
