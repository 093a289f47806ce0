// A candidate that crashes or throws in a way selected by the ray: an origin with x = k selects the
// k-th way, x = 0 a normal answer. Comments name the line of each way.

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <raycheck/candidate.hpp>
#include <stdexcept>
#include <vector>

#include "dies_elsewhere.h"

namespace {

int* volatile nowhere = nullptr;
volatile int zero = 0;
volatile std::size_t many = 1000;

void writes_nowhere() {
  *nowhere = 1;  // dies: writes to an invalid address
}

void reads_behind_a_file() {
  std::FILE* const file = std::tmpfile();
  void* const page = mmap(nullptr, 4096, PROT_READ, MAP_SHARED, fileno(file), 0);
  zero = *static_cast<volatile int*>(page);  // dies: reads beyond a file
}

void divides_by_zero() {
  zero = 7 / zero;  // dies: divides by zero
}

void does_what_is_no_instruction() {
  __builtin_trap();  // dies: executes an invalid instruction
}

void asserts() {
  assert(zero == 1);  // dies: asserts
}

void aborts() {
  std::abort();  // dies: aborts
}

void throws_what_is_no_exception() {
  throw 42;  // dies: throws an int
}

void throws() {
  throw std::runtime_error("it is\tso");  // dies: throws; throws in a noexcept function
}

void asks_a_list_for_what_it_has_not() {
  const std::vector<int> list(many);
  zero = list.at(2 * many);  // dies: reads beyond a list
}

int sum_of_all(int from) {
  volatile char room[4096];
  room[0] = static_cast<char>(from);  // dies: uses up its stack
  return from == -1 ? 0 : sum_of_all(from + 1) + room[0];
}

void uses_up_its_stack() { zero = sum_of_all(zero); }

void raises() {
  std::raise(SIGFPE);  // dies: raises
  zero = 0;
}

void sorts_what_is_not_there() {
  int* const first = nowhere;
  std::sort(first, first + many);  // dies: sorts invalid memory
  zero = 0;
}

void sorts_by_what_dies() {
  std::vector<int> list(many);
  std::sort(list.begin(), list.end(), [](int a, int b) {
    return a + *nowhere < b;  // dies: sorts by a crashing comparison
  });
  zero = list[0];
}

void frees_what_it_has_not() {
  void* const memory = std::malloc(many);
  std::free(static_cast<char*>(memory) + many / 2);  // dies: frees an invalid pointer
  zero = 0;
}

void throws_where_it_may_not() noexcept { throws(); }

void smashes_its_stack() {
  volatile char room[16];
  for (std::size_t k = 0; k < many; ++k) room[k] = 'x';
}  // dies: smashes its stack

void dies_in_an_inlined_function_of_another_file() { elsewhere::divide(zero); }

constexpr std::array<void (*)(), 17> kWays = {writes_nowhere,
                                              reads_behind_a_file,
                                              divides_by_zero,
                                              does_what_is_no_instruction,
                                              asserts,
                                              aborts,
                                              throws_what_is_no_exception,
                                              throws,
                                              asks_a_list_for_what_it_has_not,
                                              uses_up_its_stack,
                                              raises,
                                              sorts_what_is_not_there,
                                              sorts_by_what_dies,
                                              frees_what_it_has_not,
                                              throws_where_it_may_not,
                                              smashes_its_stack,
                                              dies_in_an_inlined_function_of_another_file};

std::optional<raycheck::Hit> intersect(const raycheck::Ray& ray, const raycheck::Sphere&,
                                       const raycheck::Conventions&) {
  const auto way = static_cast<std::size_t>(ray.origin.x);
  if (way > 0 && way <= kWays.size()) kWays[way - 1]();
  return {};
}

}  // namespace

RAYCHECK_CANDIDATE(.intersect = intersect)
