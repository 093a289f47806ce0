// random_bytes COUNT: calls libFuzzer's entry point with COUNT strings of random bytes, for
// compilers without libFuzzer.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count);

int main(int, char** argv) {
  std::mt19937_64 random(1);
  for (long left = std::atol(argv[1]); left > 0; --left) {
    std::vector<std::uint8_t> bytes(random() % 64);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  return 0;
}
