// A candidate that exits on the first request.

#include <unistd.h>

#include <raycheck/candidate.hpp>

namespace {

std::optional<raycheck::Hit> intersect(const raycheck::Ray&, const raycheck::Sphere&,
                                       const raycheck::Conventions&) {
  _exit(0);
}

}  // namespace

RAYCHECK_CANDIDATE(.intersect = intersect)
