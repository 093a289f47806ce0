// CS410 PA3
// usage: rayz driver.txt image.ppm
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <cmath>

#define MAXS 500
#define MAXL 50

double eye[3], look[3], up[3];
double U[3], V[3], W[3];
double dist;
double left, right, bottom, top;
int width, height;
double amb[3];
int level = 0;

int nspheres = 0;
double center[MAXS][3];
double radius[MAXS];
double Ka[MAXS][3], Kd[MAXS][3], Ks[MAXS][3];

int nlights = 0;
double lpos[MAXL][4], lcol[MAXL][3];

double dot(const double *a, const double *b)
{
    return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

void cross(const double *a, const double *b, double *c)
{
    c[0] = a[1]*b[2] - a[2]*b[1];
    c[1] = a[2]*b[0] - a[0]*b[2];
    c[2] = a[0]*b[1] - a[1]*b[0];
}

void normalize(double *a)
{
    double len = sqrt(dot(a, a));
    for (int k = 0; k < 3; k++) a[k] /= len;
}

void copy3(double *to, char **tok)
{
    for (int k = 0; k < 3; k++) to[k] = atof(tok[k]);
}

void readDriver(const char *name)
{
    char line[1024];
    char *tok[64];
    FILE *f = fopen(name, "r");
    if (!f) { fprintf(stderr, "can't open %s\n", name); exit(1); }
    while (fgets(line, sizeof line, f)) {
        int n = 0;
        char *hash = strchr(line, '#');
        if (hash) *hash = 0;
        for (char *p = strtok(line, " \t\r\n"); p && n < 64; p = strtok(NULL, " \t\r\n"))
            tok[n++] = p;
        if (n == 0) continue;
        if (!strcmp(tok[0], "eye") && n >= 4) copy3(eye, tok + 1);
        else if (!strcmp(tok[0], "look") && n >= 4) copy3(look, tok + 1);
        else if (!strcmp(tok[0], "up") && n >= 4) copy3(up, tok + 1);
        else if (!strcmp(tok[0], "d") && n >= 2) dist = atof(tok[1]);
        else if (!strcmp(tok[0], "bounds") && n >= 5) {
            left = atoi(tok[1]);
            bottom = atoi(tok[2]);
            right = atoi(tok[3]);
            top = atoi(tok[4]);
        }
        else if (!strcmp(tok[0], "res") && n >= 3) {
            width = atoi(tok[1]);
            height = atoi(tok[2]);
        }
        else if (!strcmp(tok[0], "recursionLevel") && n >= 2) level = atoi(tok[1]);
        else if (!strcmp(tok[0], "ambient") && n >= 4) copy3(amb, tok + 1);
        else if (!strcmp(tok[0], "light") && n >= 8 && nlights < MAXL) {
            copy3(lpos[nlights], tok + 1);
            lpos[nlights][3] = atof(tok[4]);
            copy3(lcol[nlights], tok + 5);
            nlights++;
        }
        else if (!strcmp(tok[0], "sphere") && n >= 14 && nspheres < MAXS) {
            copy3(center[nspheres], tok + 1);
            radius[nspheres] = atof(tok[4]);
            copy3(Ka[nspheres], tok + 5);
            copy3(Kd[nspheres], tok + 8);
            copy3(Ks[nspheres], tok + 11);
            nspheres++;
        }
    }
    fclose(f);
}

void setupCamera()
{
    for (int k = 0; k < 3; k++) W[k] = eye[k] - look[k];
    normalize(W);
    cross(up, W, U);
    normalize(U);
    cross(W, U, V);
}

// returns the index of the closest sphere or -1
int closest(const double *L, const double *D, double *best)
{
    int which = -1;
    *best = 1e300;
    for (int i = 0; i < nspheres; i++) {
        double T[3];
        for (int k = 0; k < 3; k++) T[k] = center[i][k] - L[k];
        double v = dot(T, D);
        double dsq = radius[i]*radius[i] - (dot(T, T) - v*v);
        if (dsq < 0) continue;
        double s = v - sqrt(dsq);
        if (s < 0) s = v + sqrt(dsq);
        if (s < 0) continue;
        if (s < *best) { *best = s; which = i; }
    }
    return which;
}

void color(int i, const double *L, const double *D, double s, int *rgb)
{
    double Q[3], N[3], c[3];
    for (int k = 0; k < 3; k++) { Q[k] = L[k] + s*D[k]; N[k] = Q[k] - center[i][k]; c[k] = amb[k]*Ka[i][k]; }
    normalize(N);
    if (dot(N, D) > 0) for (int k = 0; k < 3; k++) N[k] = -N[k];
    for (int m = 0; m < nlights; m++) {
        double T[3], R[3], back[3];
        for (int k = 0; k < 3; k++) T[k] = lpos[m][k] - lpos[m][3]*Q[k];
        normalize(T);
        double nl = dot(N, T);
        if (nl <= 0) continue;
        for (int k = 0; k < 3; k++) { R[k] = 2*nl*N[k] - T[k]; back[k] = -D[k]; }
        double rv = dot(R, back);
        double shine = rv > 0 ? pow(rv, 16) : 0;
        for (int k = 0; k < 3; k++) c[k] += lcol[m][k]*(Kd[i][k]*nl + Ks[i][k]*shine);
    }
    for (int k = 0; k < 3; k++) {
        rgb[k] = (int)(255*c[k] + 0.5);
        if (rgb[k] > 255) rgb[k] = 255;
    }
}

int main(int argc, char **argv)
{
    if (argc < 3) { fprintf(stderr, "usage: %s driver image\n", argv[0]); return 1; }
    readDriver(argv[1]);
    setupCamera();
    FILE *out = fopen(argv[2], "w");
    if (!out) return 1;
    fprintf(out, "P3\n%d %d 255\n", width, height);
    for (int j = 0; j < height; j++) {
        for (int i = 0; i < width; i++) {
            double px = left + (right - left)*i/(width - 1);
            double py = top + (bottom - top)*j/(height - 1);
            double L[3], D[3], s;
            for (int k = 0; k < 3; k++) {
                D[k] = -dist*W[k] + px*U[k] + py*V[k];
                L[k] = eye[k] + D[k];
            }
            normalize(D);
            int rgb[3] = {0, 0, 0};
            int hit = closest(L, D, &s);
            if (hit >= 0) color(hit, L, D, s, rgb);
            fprintf(out, "%d %d %d ", rgb[0], rgb[1], rgb[2]);
        }
        fprintf(out, "\n");
    }
    fclose(out);
    return 0;
}
