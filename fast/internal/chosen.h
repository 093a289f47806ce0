#pragma once

#include "fast/intersect.h"

namespace raycheck::fast {

/// The answer to one ray; without a hit `at` means nothing. Internal to fast/.
struct Chosen {
  bool hit;
  Hit at;
};

}  // namespace raycheck::fast
