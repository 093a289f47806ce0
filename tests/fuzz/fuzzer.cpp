// The entry of libFuzzer, compiled once for each target, which RAYCHECK_FUZZ_TARGET names.

#include "tests/fuzz/targets.h"
#include "tests/standard.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  raycheck::tests::RAYCHECK_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
