#include <raycheck/fuzz.h>

#include "tracer.h"

RAYCHECK_FUZZ(tracer(), "nearest-root")
