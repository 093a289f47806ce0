#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "tracer.h"

#include <raycheck/doctest.h>

RAYCHECK_TESTS("tracer", tracer());
