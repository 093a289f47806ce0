#ifndef RAYCHECK_FAST_INTERNAL_CHOSEN_H_
#define RAYCHECK_FAST_INTERNAL_CHOSEN_H_

#include "fast/intersect.h"

namespace raycheck::fast {

/// The answer to one ray; without a hit `at` means nothing. Internal to fast/.
struct Chosen {
  bool hit;
  Hit at;
};

}  // namespace raycheck::fast

#endif  // RAYCHECK_FAST_INTERNAL_CHOSEN_H_
