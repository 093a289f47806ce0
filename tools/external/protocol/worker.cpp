// raycheck-worker LIBRARY.so
//
// Implements the protocol of docs/candidates.md with the functions of a library
// (raycheck/candidate.h): requests come on standard input, replies go to standard output. Output of
// the library itself goes to standard error. If the library crashes or throws, a line reports the
// place in its code (frames.h). Exits with 2 and a message if the file is not such a library.

#include <dlfcn.h>
#include <raycheck/candidate.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "properties/case.h"
#include "properties/returns.h"
#include "scene/precision.h"
#include "tools/external/protocol/frames.h"
#include "tools/external/protocol/words.h"
#include "tools/external/sandbox/awake.h"

namespace {

using raycheck::tools::kConventionWords;
using raycheck::tools::kEndsWords;
using raycheck::tools::Words;
namespace scene = raycheck::scene;

[[noreturn]] void give_up(const std::string& why) {
  std::fprintf(stderr, "raycheck-worker: %s\n", why.c_str());
  std::exit(2);
}

/// The next line of the standard input, valid until the next call; empty at its end.
std::optional<Words> next_line() {
  static char* line = nullptr;
  static std::size_t size = 0;
  const ssize_t length = getline(&line, &size, stdin);
  if (length < 0) return {};
  std::string_view text(line, static_cast<std::size_t>(length));
  while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
  return Words(text, 0);
}
Words require_line() {
  const std::optional<Words> line = next_line();
  if (!line) give_up("the input ends within a request");
  return *line;
}

/// Builds a reply, with numbers as shortest decimals.
class Reply {
 public:
  explicit Reply(std::FILE* to) : to_(to) {}
  Reply& operator<<(std::string_view text) {
    buffer_ += text;
    return *this;
  }
  Reply& operator<<(double x) {
    char digits[40];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, x);
    buffer_.append(digits, end);
    return *this;
  }
  Reply& operator<<(std::int64_t x) {
    buffer_ += std::to_string(x);
    return *this;
  }
  Reply& operator<<(const raycheck_vector& v) { return *this << v.x << " " << v.y << " " << v.z; }
  void send() {
    std::fwrite(buffer_.data(), 1, buffer_.size(), to_);
    std::fflush(to_);
    buffer_.clear();
  }

 private:
  std::FILE* to_;
  std::string buffer_;
};

struct Request {
  std::string id, function;
  raycheck_asked asked{};
  raycheck_camera camera{};
  std::vector<raycheck_pixel> pixels;
  std::vector<raycheck_ray> rays;
  std::vector<raycheck_sphere> spheres;
};

std::int32_t place(Words& words, std::span<const std::string_view> names) {
  return static_cast<std::int32_t>(words.place_in(names, "has an unknown name"));
}

template <class Item, class Read>
void read_list(std::int64_t count, std::vector<Item>& list, Read read) {
  for (std::int64_t k = 0; k < count; ++k) {
    Words words = require_line();
    list.push_back(read(words));
  }
}

void read_part(std::string_view kind, Words& words, Request& request) {
  if (kind == "conventions") {
    auto& c = request.asked.conventions;
    std::size_t which = 0;
    for (std::int32_t* value : {&c.rows, &c.samples, &c.origin, &c.root, &c.tangent}) {
      *value = 1 + place(words, kConventionWords[which++].values);
    }
  } else if (kind == "roots") {
    auto& v = request.asked.valid;
    v.ends = place(words, kEndsWords);
    v.t_min = words.number();
    v.t_max = words.number();
    v.unit = place(words, scene::kTUnitNames);
    v.culling = place(words, scene::kCullingNames);
  } else if (kind == "camera") {
    auto& c = request.camera;
    for (raycheck_vector* vector : {&c.eye, &c.look_at, &c.up}) {
      *vector = words.triple<raycheck_vector>();
    }
    for (double* value : {&c.near_plane, &c.left, &c.right, &c.bottom, &c.top}) {
      *value = words.number();
    }
    c.width = words.integer();
    c.height = words.integer();
  } else if (kind == "pixels") {
    read_list(words.integer(), request.pixels, [](Words& line) {
      const std::int64_t i = line.integer(), j = line.integer();
      return raycheck_pixel{i, j};
    });
  } else if (kind == "rays") {
    read_list(words.integer(), request.rays, [](Words& line) {
      const auto origin = line.triple<raycheck_vector>();
      return raycheck_ray{origin, line.triple<raycheck_vector>()};
    });
  } else if (kind == "spheres") {
    read_list(words.integer(), request.spheres, [](Words& line) {
      const auto centre = line.triple<raycheck_vector>();
      return raycheck_sphere{centre, line.number()};
    });
  } else {
    give_up("no such part of a request: " + std::string(kind));
  }
}

/// Reads a request; empty at the end of the input.
std::optional<Request> read_request() {
  std::optional<Words> first = next_line();
  if (!first) return {};
  Request request;
  request.asked.valid.t_max = std::numeric_limits<double>::infinity();
  if (first->word() != "request") give_up("expected a request");
  request.id = first->word();
  request.function = first->word();
  for (;;) {
    Words words = require_line();
    const std::string_view kind = words.word();
    if (kind == "end") return request;
    read_part(kind, words, request);
  }
}

bool offers_intersect(const raycheck_candidate& candidate) {
  return candidate.intersect != nullptr || candidate.intersect_batch != nullptr;
}

void intersect(const raycheck_candidate& candidate, const Request& request, Reply& reply) {
  std::vector<raycheck_hit> hits(request.rays.size());
  for (std::size_t sphere = 0; sphere < request.spheres.size(); ++sphere) {
    if (candidate.intersect_batch != nullptr) {
      candidate.intersect_batch(request.rays.data(), request.rays.size(), &request.spheres[sphere],
                                &request.asked.conventions, hits.data());
    } else {
      for (std::size_t ray = 0; ray < hits.size(); ++ray) {
        hits[ray] = candidate.intersect(&request.rays[ray], &request.spheres[sphere],
                                        &request.asked.conventions);
      }
    }
    for (std::size_t ray = 0; ray < hits.size(); ++ray) {
      if (hits[ray].hit == 0) continue;
      reply << static_cast<std::int64_t>(ray) << " " << static_cast<std::int64_t>(sphere) << " "
            << hits[ray].parameter << " " << hits[ray].point << "\n";
    }
  }
}

void answer(const raycheck_candidate& candidate, const Request& request, Reply& reply) {
  const std::string& function = request.function;
  if (function == "frame" && candidate.frame != nullptr) {
    const raycheck_frame frame = candidate.frame(&request.camera);
    reply << frame.u << "\n" << frame.v << "\n" << frame.w << "\n";
  } else if (function == "pixel_point" && candidate.pixel_point != nullptr) {
    for (const raycheck_pixel& pixel : request.pixels) {
      reply << candidate.pixel_point(&request.camera, &request.asked.conventions, pixel) << "\n";
    }
  } else if (const auto make = function == "pixel_ray"   ? candidate.pixel_ray
                               : function == "focal_ray" ? candidate.focal_ray
                                                         : nullptr;
             make != nullptr) {
    for (const raycheck_pixel& pixel : request.pixels) {
      const auto ray = make(&request.camera, &request.asked.conventions, pixel);
      reply << ray.origin << " " << ray.direction << "\n";
    }
  } else if (function == "intersect" && offers_intersect(candidate)) {
    intersect(candidate, request, reply);
  } else if (function == "nearest" && candidate.nearest != nullptr) {
    for (const raycheck_ray& ray : request.rays) {
      const std::int64_t index = candidate.nearest(
          &ray, request.spheres.data(), request.spheres.size(), &request.asked.conventions);
      if (index < 0) {
        reply << "none\n";
      } else {
        reply << index << "\n";
      }
    }
  } else {
    throw std::invalid_argument("the candidate has no function " + function);
  }
}

/// The name of an enumerator; the first one has the value `first`.
std::string_view name_in(std::span<const std::string_view> names, std::int32_t value,
                         std::string_view what, std::int32_t first = 0) {
  const std::int64_t index = std::int64_t{value} - first;
  if (index < 0 || index >= std::ssize(names)) {
    give_up("the candidate declares an unknown value of " + std::string(what) + ": " +
            std::to_string(value));
  }
  return names[static_cast<std::size_t>(index)];
}

/// Adds the lines that libraries of version 1 lack.
void introduce_contract(const raycheck_candidate& candidate, Reply& reply) {
  if (candidate.level != RAYCHECK_LEVEL_UNSTATED) {
    reply << "level " << name_in(raycheck::properties::kLevelNames, candidate.level, "level", 1)
          << "\n";
  }
  if (candidate.smallest_length != 0 || candidate.largest_length != 0) {
    reply << "lengths " << candidate.smallest_length << " " << candidate.largest_length << "\n";
  }
}

/// Adds the lines that libraries of versions 1 and 2 lack.
void introduce_numbers(const raycheck_candidate& candidate, Reply& reply) {
  if (candidate.precision != RAYCHECK_PRECISION_DOUBLE) {
    reply << "precision " << name_in(scene::kPrecisionNames, candidate.precision, "precision")
          << "\n";
  }
  const raycheck_valid_roots& v = candidate.declared_roots;
  if (candidate.roots == RAYCHECK_ROOTS_AS_ASKED) {
    reply << "roots as-asked\n";
  } else if (candidate.roots == RAYCHECK_ROOTS_DECLARED) {
    reply << "roots " << name_in(std::span(kEndsWords).first(4), v.ends, "ends") << " " << v.t_min
          << " " << v.t_max << " " << name_in(scene::kTUnitNames, v.unit, "unit") << " "
          << name_in(scene::kCullingNames, v.culling, "culling") << "\n";
  } else if (candidate.roots != RAYCHECK_ROOTS_USUAL) {
    give_up("the candidate declares an unknown value of roots: " + std::to_string(candidate.roots));
  }
}

/// Adds the lines that libraries of versions 1 to 3 lack.
void introduce_answers(const raycheck_candidate& candidate, Reply& reply) {
  using raycheck::tools::kDirectionsWords;
  reply << "directions " << name_in(kDirectionsWords, candidate.directions, "directions") << "\n"
        << "returns "
        << name_in(raycheck::properties::kReturnsNames, candidate.returns, "kind of answer")
        << "\n";
}

void introduce(const raycheck_candidate& candidate, Reply& reply) {
  reply << "raycheck 1 " << (candidate.name != nullptr ? candidate.name : "-") << "\n";
  const std::array<bool, 6> has = {candidate.frame != nullptr,     candidate.pixel_point != nullptr,
                                   candidate.pixel_ray != nullptr, candidate.focal_ray != nullptr,
                                   offers_intersect(candidate),    candidate.nearest != nullptr};
  for (std::size_t k = 0; k < has.size(); ++k) {
    if (has[k]) reply << "function " << raycheck::tools::kFunctions[k] << "\n";
  }
  const auto& d = candidate.declared;
  const std::array<std::int32_t, 5> declared = {d.rows, d.samples, d.origin, d.root, d.tangent};
  for (std::size_t k = 0; k < declared.size(); ++k) {
    if (declared[k] == RAYCHECK_AS_ASKED) continue;
    const auto& [name, values] = kConventionWords[k];
    reply << "convention " << name << " " << name_in(values, declared[k], name, 1) << "\n";
  }
  if (candidate.version >= 2) introduce_contract(candidate, reply);
  if (candidate.version >= 3) introduce_numbers(candidate, reply);
  if (candidate.version >= 4) introduce_answers(candidate, reply);
  reply << "ready\n";
  reply.send();
}

const raycheck_candidate& load(const char* path) {
  void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) give_up(dlerror());
  raycheck::tools::follow(library);
  using Functions = const raycheck_candidate* (*)();
  const auto functions =
      reinterpret_cast<Functions>(dlsym(library, "raycheck_candidate_functions"));
  if (functions == nullptr)
    give_up(
        "the library has no raycheck_candidate_functions(); in C++, RAYCHECK_CANDIDATE(...) "
        "defines it");
  const raycheck_candidate* const candidate = functions();
  if (candidate == nullptr) give_up("raycheck_candidate_functions() returns null");
  if (candidate->version < 1 || candidate->version > RAYCHECK_CANDIDATE_VERSION) {
    give_up("the library was built for version " + std::to_string(candidate->version) +
            " of <raycheck/candidate.h>; raycheck-worker supports versions up to " +
            std::to_string(RAYCHECK_CANDIDATE_VERSION));
  }
  return *candidate;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) give_up("usage: raycheck-worker LIBRARY.so");
  // Before any code of the library runs, replies get a separate stream.
  const int replies = dup(STDOUT_FILENO);
  if (replies < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) give_up(std::strerror(errno));
  Reply reply(fdopen(replies, "w"));
  raycheck::tools::report_deaths(replies);
  const raycheck_candidate& candidate = load(argv[1]);
  if (std::optional<Words> first = next_line(); !first || first->word() != "raycheck") {
    give_up("started without raycheck: 'raycheck 1' is missing on standard input");
  }
  introduce(candidate, reply);
  while (const std::optional<Request> request = read_request()) {
    reply << "reply " << request->id << "\n";
    try {
      answer(candidate, *request, reply);
      reply << "end " << request->id << "\n";
    } catch (const std::exception& error) {
      reply << raycheck::tools::frames_of_throw(error);
      reply << "error " << request->id << " " << error.what() << "\n";
    }
    reply.send();
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    raycheck::tools::poll_awake(&input, 1);
  }
  return 0;
}
