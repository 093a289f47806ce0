#pragma once

namespace raycheck::tools {

/// Takes --target=NAME (AVX2, SSE4, EMU128 and so on) out of a benchmark's arguments: Highway then
/// runs that target and no better. False, once it has said so, where this machine has no such
/// target.
bool choose_target(int& argc, char** argv);

}  // namespace raycheck::tools
