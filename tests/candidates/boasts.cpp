// A candidate that prints a full score and good answers before anything was asked, has square roots
// and memory of its own, and answers the same whatever is asked.

#include <cstdio>
#include <cstdlib>
#include <raycheck/candidate.hpp>

extern "C" {
double sqrt(double) { return 1; }
void* malloc(std::size_t size) {
  static char memory[1 << 24];
  static std::size_t used = 0;
  used = (used + 15) & ~std::size_t{15};
  if (used + size > sizeof memory) return nullptr;
  void* const found = memory + used;
  used += size;
  return found;
}
void free(void*) {}
}

namespace {

struct Boast {
  Boast() {
    std::puts("raycheck 1 perfect\nfunction intersect\nready\nreply 1\nend 1\nscore 100");
    std::fflush(stdout);
  }
} boast;

std::optional<raycheck::Hit> intersect(const raycheck::Ray&, const raycheck::Sphere&,
                                       const raycheck::Conventions&) {
  return raycheck::Hit{1, {0, 0, 0}};
}

}  // namespace

RAYCHECK_CANDIDATE(.name = "perfect", .intersect = intersect)
