#define SINGLE
#include "wildmagic-ray.cpp"
