#define SINGLE
#include "glm.cpp"
