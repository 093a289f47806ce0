#include "tracer.h"

#include <raycheck/fuzz.h>

RAYCHECK_FUZZ(tracer(), "nearest-root")
