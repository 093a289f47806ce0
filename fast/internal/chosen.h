#pragma once

#include "fast/intersect.h"

namespace raycheck::fast {

/// The answer to one ray; `at` is valid only for a hit. Internal to fast/.
struct Chosen {
  bool hit;
  Hit at;
};

}  // namespace raycheck::fast
