#include "tools/external/protocol/protocol.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "scene/fields.h"
#include "scene/number.h"
#include "scene/validate.h"

namespace raycheck::tools {
namespace {

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

/// Reads a word that must be one of these names, which are in the order of the enumeration.
template <class Enum>
Enum choose(Words& words, std::span<const std::string_view> names, const char* otherwise) {
  return static_cast<Enum>(words.place_in(names, otherwise));
}

std::optional<scene::ValidRoots> read_roots(Words& words) {
  constexpr const char* kOtherwise = "declares unknown roots";
  scene::Conventions conventions;
  scene::ValidRoots& valid = conventions.valid;
  const std::size_t ends = words.place_in(kEndsWords, kOtherwise);
  if (ends + 1 == kEndsWords.size()) return {};
  valid.ends = static_cast<scene::Ends>(ends);
  valid.t_min = words.number();
  valid.t_max = words.number();
  valid.unit = choose<scene::TUnit>(words, scene::kTUnitNames, kOtherwise);
  valid.culling = choose<scene::Culling>(words, scene::kCullingNames, kOtherwise);
  if (!scene::defects(conventions).empty()) words.fail("declares an invalid interval");
  return valid;
}

void read_convention(Words& words, properties::DeclaredConventions& declared) {
  constexpr const char* kOtherwise = "declares an unknown convention";
  const std::string_view which = words.word();
  bool is_known = false;
  scene::for_each_choice(declared, [&](std::string_view name, auto& choice) {
    using Enum = typename std::decay_t<decltype(choice)>::value_type;
    if (name != which) return;
    choice = choose<Enum>(words, names_of(Enum{}), kOtherwise);
    is_known = true;
  });
  if (!is_known) words.fail(kOtherwise);
}

/// Reads the rest of a line that begins with `kind`.
void read_statement(std::string_view kind, Words& words, Introduction& introduction) {
  if (kind == "function") {
    introduction.functions.emplace(
        kFunctions[words.place_in(kFunctions, "offers an unknown function")]);
  } else if (kind == "convention") {
    read_convention(words, introduction.declared);
  } else if (kind == "precision") {
    introduction.precision =
        choose<scene::Precision>(words, scene::kPrecisionNames, "states an unknown precision");
  } else if (kind == "roots") {
    introduction.declared.valid = read_roots(words);
  } else if (kind == "directions") {
    introduction.unit_directions =
        words.place_in(kDirectionsWords, "states unknown directions") == 1;
  } else if (kind == "returns") {
    introduction.returns = choose<properties::Returns>(words, properties::kReturnsNames,
                                                       "states an unknown kind of answer");
  } else if (kind == "level") {
    introduction.level =
        choose<properties::Level>(words, properties::kLevelNames, "states an unknown level");
  } else if (kind == "lengths") {
    introduction.smallest_length = words.number();
    introduction.largest_length = words.number();
    if (!(introduction.smallest_length >= 0 &&
          introduction.smallest_length < introduction.largest_length)) {
      words.fail("states an invalid range of lengths");
    }
  } else {
    words.fail("does not belong to an introduction");
  }
}

}  // namespace

std::string roots_line(const scene::ValidRoots& valid) {
  return fmt::format("roots {} {} {} {} {}\n", kEndsWords[static_cast<std::size_t>(valid.ends)],
                     scene::shortest(valid.t_min), scene::shortest(valid.t_max), name(valid.unit),
                     name(valid.culling));
}

Introduction parse_introduction(std::string_view text) {
  Introduction introduction;
  const auto lines = lines_of(text);
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    Words words(lines[k], k + 1);
    const std::string_view kind = words.word();
    if (k == 0) {
      if (kind != "raycheck") words.fail("is not 'raycheck 1 NAME'");
      const std::string_view version = words.word();
      if (version != std::to_string(kProtocolVersion)) {
        words.fail(fmt::format("has the version {}, not {}", shown(version), kProtocolVersion));
      }
      introduction.name = words.word();
    } else {
      read_statement(kind, words, introduction);
    }
    words.end();
  }
  if (lines.size() < 2)
    throw ProtocolError("it did not introduce itself: 'raycheck 1 NAME' is missing");
  return introduction;
}

Request::Request(std::string id, std::string_view function, const scene::Conventions& conventions)
    : id_(std::move(id)),
      body_(fmt::format("{}\nconventions {} {} {} {} {}\n", function, name(conventions.rows),
                        name(conventions.samples), name(conventions.origin), name(conventions.root),
                        name(conventions.tangent))) {
  // The line is left out if every root >= 0 counts, so that candidates need not read it.
  if (!conventions.valid.is_usual()) body_ += roots_line(conventions.valid);
}

std::string Request::text() const { return fmt::format("request {0} {1}end {0}\n", id_, body_); }

Request& Request::camera(const scene::Camera& camera) {
  body_ += fmt::format("camera {} {} {} {} {} {} {} {} {} {}\n", scene::shortest_words(camera.eye),
                       scene::shortest_words(camera.look_at), scene::shortest_words(camera.up),
                       scene::shortest(camera.near), scene::shortest(camera.left),
                       scene::shortest(camera.right), scene::shortest(camera.bottom),
                       scene::shortest(camera.top), camera.width, camera.height);
  return *this;
}

Request& Request::pixels(std::span<const scene::Pixel> pixels) {
  body_ += fmt::format("pixels {}\n", pixels.size());
  for (const auto& [i, j] : pixels) fmt::format_to(std::back_inserter(body_), "{} {}\n", i, j);
  return *this;
}

Request& Request::rays(std::span<const scene::Ray> rays) {
  body_ += fmt::format("rays {}\n", rays.size());
  for (const auto& [origin, direction] : rays) {
    body_ += scene::shortest_words(origin) + " " + scene::shortest_words(direction) + "\n";
  }
  return *this;
}

Request& Request::spheres(std::span<const scene::Sphere> spheres) {
  body_ += fmt::format("spheres {}\n", spheres.size());
  for (const auto& [centre, radius] : spheres) {
    body_ += scene::shortest_words(centre) + " " + scene::shortest(radius) + "\n";
  }
  return *this;
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
      read_lines(lines_, [](Words& words) { return words.triple<scene::UnitVector3>(); });
  return {axes[0], axes[1], axes[2]};
}

std::vector<scene::Point3> Reply::points(std::size_t count) const {
  require_count(count);
  return read_lines(lines_, [](Words& words) { return words.triple<scene::Point3>(); });
}

std::vector<scene::Ray> Reply::rays(std::size_t count) const {
  require_count(count);
  return read_lines(lines_, [](Words& words) {
    const auto origin = words.triple<scene::Point3>();
    return scene::Ray{origin, words.triple<scene::Vector3>()};
  });
}

std::vector<SphereHits> Reply::hits(std::size_t rays, std::size_t spheres) const {
  std::vector<SphereHits> hits(spheres);
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    Words words(lines_[k], k + 2);
    const std::size_t ray = index(words, rays);
    SphereHits& of_sphere = hits[index(words, spheres)];
    const double parameter = words.number();
    of_sphere.push_back({ray, {parameter, words.triple<scene::Point3>()}});
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
