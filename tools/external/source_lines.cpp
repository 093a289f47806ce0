#include "tools/external/source_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <exception>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "scene/files/file_text.h"
#include "tools/external/protocol/frames.h"
#include "tools/external/sandbox/process.h"

namespace raycheck::tools {

namespace {

namespace fs = std::filesystem;
using properties::CodeLine;

constexpr double kSeconds = 30;
/// No person writes a longer source file.
constexpr std::uintmax_t kMostSourceBytes = std::uintmax_t{16} << 20;
/// What of a line is shown.
constexpr std::size_t kMostShown = 200;

/// A line of a text, as it is shown; of no file; empty where the text has fewer.
std::optional<CodeLine> line_of(std::string_view text, std::int64_t number) {
  for (std::int64_t k = 1; k < number; ++k) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    text.remove_prefix(end + 1);
  }
  if (text.empty()) return std::nullopt;
  text = text.substr(0, text.find('\n'));
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t begin = std::min(text.find_first_not_of(kSpace), text.size());
  std::size_t end = std::min(text.find_last_not_of(kSpace) + 1, begin + kMostShown);
  // Not in the middle of a letter of several bytes.
  while (end < text.size() && end > begin &&
         (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    --end;
  }
  end = std::max(begin, end);
  return CodeLine{"", number, std::string(text.substr(begin, end - begin))};
}

/// The path of a file in a folder, links followed; empty where it lies elsewhere, or is none.
fs::path path_in(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error || !fs::is_regular_file(real, error)) return {};
  const fs::path inside = real.lexically_relative(fs::canonical(folder, error));
  return error || inside.empty() || *inside.begin() == ".." ? fs::path() : inside;
}

}  // namespace

SourceLines::SourceLines(const Confined& program, fs::path library, fs::path compiled,
                         fs::path named)
    : addr2line_(program),
      library_(std::move(library)),
      compiled_(std::move(compiled)),
      named_(std::move(named)) {
  // Neither is its time the candidate's, nor is what keeps it from running the candidate's doing.
  addr2line_.spent = std::make_shared<SpentTime>();
  addr2line_.surroundings = nullptr;
  addr2line_.limits = Limits{};
  addr2line_.limits.seconds = kSeconds;
}

std::optional<CodeLine> SourceLines::innermost(const std::vector<std::uint64_t>& frames) const {
  if (frames.empty()) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const auto [at, is_new] = found_.try_emplace(frames);
  if (is_new) at->second = find(frames);
  return at->second;
}

std::optional<CodeLine> SourceLines::find(const std::vector<std::uint64_t>& frames) const try {
  Confined confined = addr2line_;
  confined.arguments = {"addr2line", "-i", "-e", library_.string()};
  for (const std::uint64_t frame : frames) {
    confined.arguments.push_back(fmt::format("{:#x}", frame));
  }
  Process process(confined);
  if (process.finish() != 0) return std::nullopt;
  // A line for each frame, and behind it one for each function that it is inlined in.
  const std::string said = process.printed().text();
  std::string_view rest = said;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (auto line = own_line(rest.substr(0, end))) return line;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return std::nullopt;
} catch (const std::exception&) {
  return std::nullopt;  // the failure itself is told without
}

/// Of "/source/tracer.cpp:42 (discriminator 3)".
std::optional<CodeLine> SourceLines::own_line(std::string_view place) const {
  constexpr std::string_view kDiscriminator = " (discriminator ";
  place = place.substr(0, place.rfind(kDiscriminator));
  const std::size_t colon = place.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  std::int64_t number = 0;
  const auto [end, error] =
      std::from_chars(place.data() + colon + 1, place.data() + place.size(), number);
  if (error != std::errc() || end != place.data() + place.size() || number < 1) return std::nullopt;
  const fs::path file(place.substr(0, colon));
  const fs::path inside = file.is_absolute() ? path_in(compiled_, file) : fs::path();
  if (inside.empty()) return std::nullopt;
  auto line = line_of(scene::file_text(file, kMostSourceBytes), number);
  if (line) line->file = (named_ / inside).lexically_normal().string();
  return line;
}

namespace {

/// The last complete line that begins with the word; empty if there is no such line.
std::string_view frames_line(std::string_view text) {
  std::string_view found;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(kFramesWord)) found = line.substr(kFramesWord.size());
    text.remove_prefix(end + 1);
  }
  return found;
}

}  // namespace

std::vector<std::uint64_t> frames_in(std::string_view text) {
  std::string_view rest = frames_line(text);
  std::vector<std::uint64_t> frames;
  while (!rest.empty()) {
    if (rest.front() != ' ' || frames.size() == kMostFrames) return {};
    rest.remove_prefix(1);
    std::uint64_t& frame = frames.emplace_back();
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), frame, 16);
    if (error != std::errc()) return {};
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  }
  return frames;
}

}  // namespace raycheck::tools
