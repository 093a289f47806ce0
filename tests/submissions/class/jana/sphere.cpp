#include "sphere.h"

double Sphere::distance() const { return sqrt(x * x + y * y + z * z) - radius; }
