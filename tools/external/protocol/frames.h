#pragma once

// The line in which raycheck-worker says where in its own code a library died or threw: "frames"
// and the innermost frames first, hexadecimal offsets in the library's file.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace raycheck::tools {

inline constexpr std::string_view kFramesWord = "frames";
/// Of a function that headers of others call, as a comparison that is sorted by, its own frame lies
/// some further out; this many tell enough.
inline constexpr std::size_t kMostFrames = 16;
/// An offset is a space and at most 16 digits.
inline constexpr std::size_t kMostFramesLine = kFramesWord.size() + 17 * kMostFrames + 1;

/// The frames in the last such line of what a worker wrote; none where there is no such line, or
/// one that is of another form: what it runs may write there, too.
std::vector<std::uint64_t> frames_in(std::string_view text);

}  // namespace raycheck::tools
