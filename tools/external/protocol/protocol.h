#pragma once

// The lines that raycheck and a candidate's process exchange (specified in docs/candidates.md).

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "contract/declarations.h"
#include "contract/words.h"
#include "properties/candidate.h"
#include "scene/scene.h"

namespace raycheck::tools {

using contract::ProtocolError;

inline constexpr int kProtocolVersion = 1;

/// A candidate's introduction.
struct Introduction {
  std::string name;  ///< "-" if it declares no name.
  std::set<std::string> functions;
  contract::Declarations declared;
};
inline constexpr std::string_view kGreeting = "raycheck 1\n";
inline constexpr std::string_view kReady = "ready";
inline constexpr std::size_t kMostIntroduction = 4096;  ///< bytes
/// Whether the first line of a program's output can begin an introduction.
inline bool begins_introduction(std::string_view line) { return line.starts_with("raycheck "); }
Introduction parse_introduction(std::string_view text);

/// Builds a request.
class Request {
 public:
  Request(std::string id, std::string_view function, const scene::Conventions& conventions);
  Request& camera(const scene::Camera& camera);
  Request& pixels(std::span<const scene::Pixel> pixels);
  Request& rays(std::span<const scene::Ray> rays);
  Request& spheres(std::span<const scene::Sphere> spheres);

  const std::string& id() const { return id_; }
  /// The whole request.
  std::string text() const;
  /// The request without its id.
  const std::string& body() const { return body_; }

 private:
  template <class Thing>
  Request& list(std::string_view kind, std::span<const Thing> things);

  std::string id_, body_;
};

/// Whether a line ends the reply to a request: "end ID" or "error ID ...".
bool ends_reply(std::string_view line, std::string_view id);

/// The lines between "reply ID" and "end ID".
/// Errors: ProtocolError, also for "error ID ...", with the candidate's message.
class Reply {
 public:
  Reply(std::string_view text, std::string_view id);

  properties::FrameAnswer frame() const;
  std::vector<scene::Point3> points(std::size_t count) const;
  std::vector<scene::Ray> rays(std::size_t count) const;
  std::vector<properties::SphereHits> hits(std::size_t rays, std::size_t spheres) const;
  std::vector<std::optional<std::size_t>> nearest(std::size_t rays, std::size_t spheres) const;

 private:
  void require_count(std::size_t count) const;

  std::vector<std::string_view> lines_;
};

/// An upper bound on the bytes of a reply with `lines` lines, at most kMostBytes.
inline constexpr std::size_t kMostBytes = std::size_t{1} << 28;
constexpr std::size_t most_bytes(std::size_t lines) {
  return lines < kMostBytes / 320 ? 4096 + 320 * lines : kMostBytes;
}

}  // namespace raycheck::tools
