#include "tools/external/source_lines.h"

#include <fmt/core.h>

#include <boost/algorithm/string/trim.hpp>
#include <charconv>
#include <exception>
#include <sstream>
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
/// No source file written by hand is longer.
constexpr std::uintmax_t kMostSourceBytes = std::uintmax_t{16} << 20;
/// At most this many bytes of a line are shown.
constexpr std::size_t kMostShown = 200;

/// A line of a text, without its file name; empty if the text has fewer lines.
std::optional<CodeLine> line_of(const std::string& text, std::int64_t number) {
  std::istringstream lines(text);
  std::string line;
  for (std::int64_t k = 0; k < number; ++k) {
    if (!std::getline(lines, line)) return std::nullopt;
  }
  boost::trim(line);
  return CodeLine{"", number, std::string(cut_to(line, kMostShown))};
}

/// A file's path relative to a folder, links resolved; empty if it is outside the folder or does
/// not exist.
fs::path path_in(const fs::path& folder, const fs::path& file) {
  std::error_code error;
  const fs::path real = fs::canonical(file, error);
  if (error || !fs::is_regular_file(real, error)) return {};
  const fs::path inside = real.lexically_relative(fs::canonical(folder, error));
  return error || inside.empty() || *inside.begin() == ".." ? fs::path() : inside;
}

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

SourceLines::SourceLines(const Confined& program, fs::path library, fs::path compiled,
                         fs::path named)
    : addr2line_(program),
      library_(std::move(library)),
      compiled_(std::move(compiled)),
      named_(std::move(named)) {
  // Time and failures of addr2line are not charged to the candidate.
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
  // addr2line prints a line for each frame, followed by a line for each function into which the
  // frame is inlined.
  std::istringstream said(process.printed().text());
  for (std::string line; std::getline(said, line);) {
    if (auto found = own_line(line)) return found;
  }
  return std::nullopt;
} catch (const std::exception&) {
  return std::nullopt;  // then the failure is reported without its line
}

/// Parses "/source/tracer.cpp:42 (discriminator 3)".
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
