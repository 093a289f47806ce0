#include "bullet.cpp"
