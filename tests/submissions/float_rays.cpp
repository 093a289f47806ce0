// Those of rays.cpp in float throughout, as a tracer for a GPU computes them, and it says so.

#define NUMBER float
#define PRECISION single
#include "rays.cpp"
