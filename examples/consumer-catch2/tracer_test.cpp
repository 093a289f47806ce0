#define CATCH_CONFIG_MAIN  // of Catch2 2
#include "tracer.h"

#include <raycheck/catch2.h>

RAYCHECK_TESTS("tracer", tracer());
