#define SINGLE
#include "imath.cpp"
