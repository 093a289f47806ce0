#ifndef SCENE_H
#define SCENE_H

typedef struct { double x, y, z; } vec;

typedef struct {
    vec centre;
    double radius;
    vec ka, kd, ks;
    double distance;        /* from the eye, for sorting */
} sphere;

typedef struct {
    vec pos;
    double w;
    vec rgb;
} light;

typedef struct {
    vec eye, look, up;
    double d;
    double left, right, bottom, top;
    int cols, rows;
    vec ambient;
    light *lights;
    int nlights;
    sphere *spheres;
    int nspheres;
} scene;

int read_scene(const char *path, scene *sc);

vec add(vec a, vec b);
vec sub(vec a, vec b);
vec scale(double k, vec a);
vec cross(vec a, vec b);
vec unit(vec a);
double dot(vec a, vec b);

#endif
