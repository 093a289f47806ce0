// raycheck-worker LIBRARY.so
//
// Implements the protocol of docs/candidates.md with the functions of a library
// (raycheck/candidate.h): requests come on standard input, replies go to standard output. Output of
// the library itself goes to standard error. If the library crashes or throws, a line reports the
// place in its code (frames.h). Exits with 2 and a message if the file is not such a library.

#include <dlfcn.h>
#include <raycheck/candidate.h>
#include <unistd.h>

#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <vector>

#include "contract/declarations.h"
#include "contract/public_structs.h"
#include "contract/words.h"
#include "scene/scene.h"
#include "tools/external/protocol/frames.h"
#include "tools/external/sandbox/awake.h"

namespace {

namespace contract = raycheck::contract;
using contract::Words;
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
  template <class Value>
  requires(!std::convertible_to<Value, std::string_view>) Reply& operator<<(const Value& value) {
    contract::append(buffer_, value);
    return *this;
  }
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
  scene::Conventions conventions;
  raycheck_asked asked{};  ///< The same.
  raycheck_camera camera{};
  std::vector<raycheck_pixel> pixels;
  std::vector<raycheck_ray> rays;
  std::vector<raycheck_sphere> spheres;
};

template <class Item, class Made>
void read_list(Words& words, Made (*made)(const Item&), std::vector<Made>& list) {
  for (std::int64_t left = words.read<std::int64_t>(); left > 0; --left) {
    list.push_back(made(require_line().read<Item>()));
  }
}

void read_part(std::string_view kind, Words& words, Request& request) {
  if (kind == "conventions") {
    request.conventions = words.read<scene::Conventions>();
  } else if (kind == "roots") {
    request.conventions.valid = words.read<scene::ValidRoots>();
  } else if (kind == "camera") {
    request.camera = contract::camera<raycheck_camera>(words.read<scene::Camera>());
  } else if (kind == "pixels") {
    read_list<scene::Pixel>(words, contract::pixel<raycheck_pixel>, request.pixels);
  } else if (kind == "rays") {
    read_list<scene::Ray>(words, contract::ray<raycheck_ray>, request.rays);
  } else if (kind == "spheres") {
    read_list<scene::Sphere>(words, contract::sphere<raycheck_sphere>, request.spheres);
  } else {
    give_up("no such part of a request: " + std::string(kind));
  }
}

/// Reads a request; empty at the end of the input.
std::optional<Request> read_request() {
  std::optional<Words> first = next_line();
  if (!first) return {};
  Request request;
  if (first->word() != "request") give_up("expected a request");
  request.id = first->word();
  request.function = first->word();
  for (;;) {
    Words words = require_line();
    const std::string_view kind = words.word();
    if (kind == "end") {
      request.asked = {contract::conventions<raycheck_conventions>(request.conventions),
                       contract::valid_roots<raycheck_valid_roots>(request.conventions.valid)};
      return request;
    }
    read_part(kind, words, request);
  }
}

bool offers_intersect(const raycheck_candidate& candidate) {
  return candidate.intersect != nullptr || candidate.intersect_batch != nullptr;
}

bool offers_pick(const raycheck_candidate& candidate) {
  return candidate.version >= 6 && candidate.pick != nullptr;
}

void add_hit(Reply& reply, std::size_t ray, std::size_t sphere, const raycheck_hit& hit) {
  if (hit.hit == 0) return;
  reply << static_cast<std::int64_t>(ray) << " " << static_cast<std::int64_t>(sphere) << " "
        << hit.parameter << " " << hit.point << "\n";
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
    for (std::size_t ray = 0; ray < hits.size(); ++ray) add_hit(reply, ray, sphere, hits[ray]);
  }
}

void pick(const raycheck_candidate& candidate, const Request& request, Reply& reply) {
  for (std::size_t sphere = 0; sphere < request.spheres.size(); ++sphere) {
    for (std::size_t pixel = 0; pixel < request.pixels.size(); ++pixel) {
      add_hit(reply, pixel, sphere,
              candidate.pick(&request.camera, &request.asked.conventions, request.pixels[pixel],
                             &request.spheres[sphere]));
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
  } else if (function == "pick" && offers_pick(candidate)) {
    pick(candidate, request, reply);
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

void introduce(const raycheck_candidate& candidate, Reply& reply) {
  const contract::Declarations declared = contract::declarations(
      candidate, candidate.declared, candidate.declared_roots, candidate.version);
  reply << "raycheck 1 " << (candidate.name != nullptr ? candidate.name : "-") << "\n";
  const std::array<bool, 7> has = {candidate.frame != nullptr,     candidate.pixel_point != nullptr,
                                   candidate.pixel_ray != nullptr, candidate.focal_ray != nullptr,
                                   offers_intersect(candidate),    candidate.nearest != nullptr,
                                   offers_pick(candidate)};
  for (std::size_t k = 0; k < has.size(); ++k) {
    if (has[k]) reply << "function " << contract::kFunctions[k] << "\n";
  }
  for (const std::string& one : contract::statements(declared)) {
    reply << one << "\n";
  }
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
  try {
    introduce(candidate, reply);
  } catch (const std::invalid_argument& error) {
    give_up(error.what());
  }
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
