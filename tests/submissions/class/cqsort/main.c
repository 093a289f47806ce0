/* Ray tracer. Writes output.ppm. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "scene.h"

static int nearer(const void *a, const void *b)
{
    double p = ((const sphere *)a)->distance, q = ((const sphere *)b)->distance;
    return (p > q) - (p < q);
}

/* Sort once, so that the first sphere a ray hits is the one in front. */
static void sort_spheres(scene *sc)
{
    int i;
    for (i = 0; i < sc->nspheres; i++) {
        vec t = sub(sc->spheres[i].centre, sc->eye);
        sc->spheres[i].distance = sqrt(dot(t, t)) - sc->spheres[i].radius;
    }
    qsort(sc->spheres, sc->nspheres, sizeof(sphere), nearer);
}

static double intersect(const sphere *s, vec start, vec dir)
{
    vec t = sub(s->centre, start);
    double v = dot(t, dir);
    double d2 = s->radius * s->radius - (dot(t, t) - v * v);
    double d;
    if (d2 < 0)
        return -1;
    d = sqrt(d2);
    return v - d >= 0 ? v - d : v + d;
}

static unsigned char byte(double x)
{
    if (x > 1)
        x = 1;
    return (unsigned char)(255 * x);
}

static vec shade(const scene *sc, const sphere *s, vec p)
{
    vec n = unit(sub(p, s->centre));
    vec c = {sc->ambient.x * s->ka.x, sc->ambient.y * s->ka.y, sc->ambient.z * s->ka.z};
    int k;
    for (k = 0; k < sc->nlights; k++) {
        const light *l = &sc->lights[k];
        double cosine = dot(n, unit(sub(l->pos, scale(l->w, p))));
        if (cosine > 0) {
            c.x += cosine * l->rgb.x * s->kd.x;
            c.y += cosine * l->rgb.y * s->kd.y;
            c.z += cosine * l->rgb.z * s->kd.z;
        }
    }
    return c;
}

int main(int argc, char *argv[])
{
    scene sc;
    vec u, v, w;
    int i, j, k;
    FILE *out;

    if (argc < 2 || !read_scene(argv[1], &sc)) {
        fprintf(stderr, "usage: %s driver\n", argv[0]);
        return EXIT_FAILURE;
    }
    sort_spheres(&sc);
    w = unit(sub(sc.eye, sc.look));
    u = unit(cross(sc.up, w));
    v = cross(w, u);

    out = fopen("output.ppm", "wb");
    fprintf(out, "P6\n# made by %s\n%d %d\n255\n", argv[0], sc.cols, sc.rows);
    for (j = sc.rows - 1; j >= 0; j--) {
        double y = sc.bottom + (double)j / (sc.rows - 1) * (sc.top - sc.bottom);
        for (i = 0; i < sc.cols; i++) {
            double x = sc.left + (double)i / (sc.cols - 1) * (sc.right - sc.left);
            vec pixel = add(sc.eye, add(scale(sc.d, w), add(scale(x, u), scale(y, v))));
            vec dir = unit(sub(pixel, sc.eye));
            vec c = {0, 0, 0};
            for (k = 0; k < sc.nspheres; k++) {
                double s = intersect(&sc.spheres[k], sc.eye, dir);
                if (s >= 0) {
                    c = shade(&sc, &sc.spheres[k], add(sc.eye, scale(s, dir)));
                    break;
                }
            }
            fputc(byte(c.x), out);
            fputc(byte(c.y), out);
            fputc(byte(c.z), out);
        }
    }
    fclose(out);
    return 0;
}
