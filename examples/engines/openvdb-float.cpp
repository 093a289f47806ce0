#define SINGLE
#include "openvdb.cpp"
