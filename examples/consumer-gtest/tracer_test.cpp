#include "tracer.h"

#include <raycheck/gtest.h>

RAYCHECK_TESTS(Tracer, tracer());
