// The functions of rays.cpp in float throughout, like a GPU tracer, declared as single precision.

#define NUMBER float
#define PRECISION single
#include "rays.cpp"
