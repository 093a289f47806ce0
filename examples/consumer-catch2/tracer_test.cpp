#define CATCH_CONFIG_MAIN  // for Catch2 2
#include "tracer.h"

#include <raycheck/catch2.h>

RAYCHECK_TESTS("tracer", tracer());
