#include "tools/external/protocol/protocol.h"

#include <fmt/core.h>

#include <algorithm>

#include "scene/text.h"
#include "scene/validate.h"

namespace raycheck::tools {
namespace {

using contract::kShownError;
using contract::shown;
using contract::Words;
using properties::SphereHits;

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::size_t index(Words& words, std::size_t count) {
  const std::int64_t value = words.integer();
  if (value < 0) words.fail("has a negative index");
  if (static_cast<std::uint64_t>(value) >= count) {
    words.fail(fmt::format("has the index {}, which must be below {}", value, count));
  }
  return static_cast<std::size_t>(value);
}

}  // namespace

Introduction parse_introduction(std::string_view text) {
  Introduction introduction;
  const auto lines = lines_of(text);
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    Words words(lines[k], k + 1);
    if (k == 0) {
      if (words.word() != "raycheck") words.fail("is not 'raycheck 1 NAME'");
      const std::string_view version = words.word();
      if (version != std::to_string(kProtocolVersion)) {
        words.fail(fmt::format("has the version {}, not {}", shown(version), kProtocolVersion));
      }
      introduction.name = words.word();
    } else if (words.skip("function")) {
      const std::string_view function = words.word();
      if (std::ranges::find(contract::kFunctions, function) == contract::kFunctions.end()) {
        words.fail("offers an unknown function, not one of " + scene::joined(contract::kFunctions));
      }
      introduction.functions.emplace(function);
    } else {
      contract::declare(words, introduction.declared);
    }
    words.end();
  }
  if (lines.size() < 2) {
    throw ProtocolError("it did not introduce itself: 'raycheck 1 NAME' is missing");
  }
  if (const auto wrong = contract::defects(introduction.declared); !wrong.empty()) {
    throw ProtocolError("its introduction declares " + scene::sentences(wrong));
  }
  return introduction;
}

Request::Request(std::string id, std::string_view function, const scene::Conventions& conventions)
    : id_(std::move(id)), body_(fmt::format("{}\nconventions ", function)) {
  contract::append(body_, conventions);
  body_ += '\n';
  // The line is left out if every root >= 0 counts, so that candidates need not read it.
  if (!conventions.valid.is_usual()) body_ += contract::roots_line(conventions.valid);
}

std::string Request::text() const { return fmt::format("request {0} {1}end {0}\n", id_, body_); }

Request& Request::camera(const scene::Camera& camera) {
  body_ += "camera ";
  contract::append(body_, camera);
  body_ += '\n';
  return *this;
}

template <class Thing>
Request& Request::list(std::string_view kind, std::span<const Thing> things) {
  body_ += fmt::format("{} {}\n", kind, things.size());
  for (const Thing& thing : things) {
    contract::append(body_, thing);
    body_ += '\n';
  }
  return *this;
}
Request& Request::pixels(std::span<const scene::Pixel> pixels) { return list("pixels", pixels); }
Request& Request::rays(std::span<const scene::Ray> rays) { return list("rays", rays); }
Request& Request::spheres(std::span<const scene::Sphere> spheres) {
  return list("spheres", spheres);
}

bool ends_reply(std::string_view line, std::string_view id) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  const auto is = [&](std::string_view word) {
    return line.starts_with(word) && line.substr(word.size()).starts_with(id) &&
           (line.size() == word.size() + id.size() || line[word.size() + id.size()] == ' ');
  };
  return is("end ") || is("error ");
}

Reply::Reply(std::string_view text, std::string_view id) : lines_(lines_of(text)) {
  if (!lines_.empty() && lines_.back().starts_with("error ")) {
    const std::size_t message = std::string_view("error ").size() + id.size() + 1;
    const std::string_view line = lines_.back();
    throw ProtocolError("it failed: " +
                        shown(line.substr(std::min(message, line.size())), kShownError));
  }
  if (lines_.size() < 2 || lines_.front() != fmt::format("reply {}", id)) {
    throw ProtocolError(fmt::format("its reply begins with '{}', not with 'reply' and the id",
                                    lines_.empty() ? "" : shown(lines_.front())));
  }
  lines_.erase(lines_.begin());
  lines_.pop_back();
}

void Reply::require_count(std::size_t count) const {
  if (lines_.size() != count) {
    throw ProtocolError(fmt::format("its reply has {} lines, not {}", lines_.size(), count));
  }
}

namespace {

/// Reads lines of the same format. They are numbered from 2, because line 1 is the reply's first
/// line.
template <class Read>
auto read_lines(const std::vector<std::string_view>& lines, const Read& read) {
  std::vector<decltype(read(std::declval<Words&>()))> result;
  result.reserve(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    Words words(lines[k], k + 2);
    result.push_back(read(words));
    words.end();
  }
  return result;
}

}  // namespace

properties::FrameAnswer Reply::frame() const {
  require_count(3);
  const auto axes =
      read_lines(lines_, [](Words& words) { return words.read<scene::UnitVector3>(); });
  return {axes[0], axes[1], axes[2]};
}

std::vector<scene::Point3> Reply::points(std::size_t count) const {
  require_count(count);
  return read_lines(lines_, [](Words& words) { return words.read<scene::Point3>(); });
}

std::vector<scene::Ray> Reply::rays(std::size_t count) const {
  require_count(count);
  return read_lines(lines_, [](Words& words) { return words.read<scene::Ray>(); });
}

std::vector<SphereHits> Reply::hits(std::size_t rays, std::size_t spheres) const {
  std::vector<SphereHits> hits(spheres);
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    Words words(lines_[k], k + 2);
    const std::size_t ray = index(words, rays);
    SphereHits& of_sphere = hits[index(words, spheres)];
    const auto parameter = words.read<double>();
    of_sphere.push_back({ray, {parameter, words.read<scene::Point3>()}});
    words.end();
  }
  const auto by_ray = [](const auto& a, const auto& b) { return a.ray < b.ray; };
  for (SphereHits& of_sphere : hits) {
    std::ranges::stable_sort(of_sphere, by_ray);
    const auto twice = std::ranges::adjacent_find(
        of_sphere, [](const auto& a, const auto& b) { return a.ray == b.ray; });
    if (twice != of_sphere.end()) {
      throw ProtocolError(
          fmt::format("its reply has two hits of ray {} with one sphere", twice->ray));
    }
  }
  return hits;
}

std::vector<std::optional<std::size_t>> Reply::nearest(std::size_t rays,
                                                       std::size_t spheres) const {
  require_count(rays);
  return read_lines(lines_, [spheres](Words& words) -> std::optional<std::size_t> {
    Words copy = words;
    if (copy.word() == "none") {
      words = copy;
      return std::nullopt;
    }
    return index(words, spheres);
  });
}

}  // namespace raycheck::tools
