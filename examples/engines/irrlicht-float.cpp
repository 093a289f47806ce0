#define SINGLE
#include "irrlicht.cpp"
