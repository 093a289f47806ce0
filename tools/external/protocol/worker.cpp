// raycheck-worker LIBRARY.so
//
// Speaks the protocol of docs/candidates.md for the functions of <raycheck/candidate.h>: requests
// come on the standard input, replies go where the standard output was. What the library itself
// prints goes to the standard error. Where it dies, or throws what becomes an error, a line before
// that says where in its code that was (frames.h). Exits with 2, after a line about it, on a
// file that is no library.

#include <dlfcn.h>
#include <raycheck/candidate.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tools/external/protocol/frames.h"

namespace {

constexpr std::array<std::array<const char*, 4>, 5> kConventionNames = {
    {{"as-asked", "bottom-first", "top-first", nullptr},
     {"as-asked", "edges", "centres", nullptr},
     {"as-asked", "pixel", "focal", nullptr},
     {"as-asked", "nearest", "smaller", nullptr},
     {"as-asked", "hit", "miss", "either"}}};
constexpr std::array<const char*, 4> kEnds = {"[]", "[)", "(]", "()"};
constexpr std::array<const char*, 2> kUnits = {"absolute", "radius"};
constexpr std::array<const char*, 3> kCullings = {"none", "back-faces", "front-faces"};
constexpr std::array<const char*, 5> kConventions = {"rows", "samples", "origin", "root",
                                                     "tangent"};

[[noreturn]] void give_up(const std::string& why) {
  std::fprintf(stderr, "raycheck-worker: %s\n", why.c_str());
  std::exit(2);
}

/// Lines of the standard input, word by word.
class Words {
 public:
  /// False at the end of the input.
  bool next_line() {
    length_ = getline(&line_, &size_, stdin);
    if (length_ < 0) return false;
    while (length_ > 0 && (line_[length_ - 1] == '\n' || line_[length_ - 1] == '\r')) --length_;
    rest_ = std::string_view(line_, static_cast<std::size_t>(length_));
    return true;
  }
  void require_line() {
    if (!next_line()) give_up("a request without an end");
  }
  std::string_view word() {
    const std::size_t end = rest_.find(' ');
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return found;
  }
  double number() {
    std::string_view text = word();
    double value = 0;
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    const bool hex = text.starts_with("0x");
    if (hex) text.remove_prefix(2);
    const auto [at, error] =
        std::from_chars(text.data(), text.data() + text.size(), value,
                        hex ? std::chars_format::hex : std::chars_format::general);
    if (error != std::errc() || at != text.data() + text.size()) {
      give_up("not a number: " + std::string(text));
    }
    return negative ? -value : value;
  }
  std::int64_t integer() {
    const std::string_view text = word();
    std::int64_t value = 0;
    const auto [at, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || at != text.data() + text.size()) {
      give_up("not a whole number: " + std::string(text));
    }
    return value;
  }
  raycheck_vector vector() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }

 private:
  char* line_ = nullptr;
  std::size_t size_ = 0;
  ssize_t length_ = 0;
  std::string_view rest_;
};

/// What is written, numbers as shortest decimals.
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

std::int32_t convention(std::size_t which, std::string_view name) {
  const auto& names = kConventionNames[which];
  for (std::size_t k = 1; k < names.size(); ++k) {
    if (names[k] != nullptr && name == names[k]) return static_cast<std::int32_t>(k);
  }
  give_up("no such convention: " + std::string(name));
}

template <class Names>
std::int32_t index_in(const Names& names, std::string_view name) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (name == names[k]) return static_cast<std::int32_t>(k);
  }
  give_up("no such word about roots: " + std::string(name));
}

template <class Item, class Read>
void read_list(Words& words, std::vector<Item>& list, Read read) {
  const std::int64_t count = words.integer();
  for (std::int64_t k = 0; k < count; ++k) {
    words.require_line();
    list.push_back(read());
  }
}

/// False at the end of the input.
bool read_request(Words& words, Request& request) {
  request = {};
  request.asked.valid.t_max = std::numeric_limits<double>::infinity();
  if (!words.next_line()) return false;
  if (words.word() != "request") give_up("not a request");
  request.id = words.word();
  request.function = words.word();
  for (;;) {
    words.require_line();
    const std::string_view kind = words.word();
    if (kind == "end") return true;
    if (kind == "conventions") {
      auto& c = request.asked.conventions;
      std::size_t which = 0;
      for (std::int32_t* value : {&c.rows, &c.samples, &c.origin, &c.root, &c.tangent}) {
        *value = convention(which++, words.word());
      }
    } else if (kind == "roots") {
      auto& v = request.asked.valid;
      v.ends = index_in(kEnds, words.word());
      v.t_min = words.number();
      v.t_max = words.number();
      v.unit = index_in(kUnits, words.word());
      v.culling = index_in(kCullings, words.word());
    } else if (kind == "camera") {
      auto& c = request.camera;
      c.eye = words.vector();
      c.look_at = words.vector();
      c.up = words.vector();
      for (double* value : {&c.near_plane, &c.left, &c.right, &c.bottom, &c.top}) {
        *value = words.number();
      }
      c.width = words.integer();
      c.height = words.integer();
    } else if (kind == "pixels") {
      read_list(words, request.pixels, [&] {
        const std::int64_t i = words.integer(), j = words.integer();
        return raycheck_pixel{i, j};
      });
    } else if (kind == "rays") {
      read_list(words, request.rays, [&] {
        const raycheck_vector origin = words.vector(), direction = words.vector();
        return raycheck_ray{origin, direction};
      });
    } else if (kind == "spheres") {
      read_list(words, request.spheres, [&] {
        const raycheck_vector centre = words.vector();
        return raycheck_sphere{centre, words.number()};
      });
    } else {
      give_up("no such part of a request: " + std::string(kind));
    }
  }
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
  } else if (function == "pixel_ray" && candidate.pixel_ray != nullptr) {
    for (const raycheck_pixel& pixel : request.pixels) {
      const auto ray = candidate.pixel_ray(&request.camera, &request.asked.conventions, pixel);
      reply << ray.origin << " " << ray.direction << "\n";
    }
  } else if (function == "focal_ray" && candidate.focal_ray != nullptr) {
    for (const raycheck_pixel& pixel : request.pixels) {
      const auto ray = candidate.focal_ray(&request.camera, &request.asked.conventions, pixel);
      reply << ray.origin << " " << ray.direction << "\n";
    }
  } else if (function == "intersect" &&
             (candidate.intersect != nullptr || candidate.intersect_batch != nullptr)) {
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
    throw std::invalid_argument("no such function: " + function);
  }
}

/// Missing in libraries of versions 1 and 2.
void introduce_precision(const raycheck_candidate& candidate, Reply& reply) {
  switch (candidate.precision) {
    case RAYCHECK_PRECISION_DOUBLE:
      return;
    case RAYCHECK_PRECISION_SINGLE:
      reply << "precision single\n";
      return;
    default:
      give_up("no such precision: " + std::to_string(candidate.precision));
  }
}

template <class Names>
const char* name_in(const Names& names, std::int32_t index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= names.size()) {
    give_up(std::string("no such ") + what + ": " + std::to_string(index));
  }
  return names[static_cast<std::size_t>(index)];
}

void introduce_roots(const raycheck_candidate& candidate, Reply& reply) {
  const raycheck_valid_roots& v = candidate.declared_roots;
  switch (candidate.roots) {
    case RAYCHECK_ROOTS_USUAL:
      return;
    case RAYCHECK_ROOTS_AS_ASKED:
      reply << "roots as-asked\n";
      return;
    case RAYCHECK_ROOTS_DECLARED:
      reply << "roots " << name_in(kEnds, v.ends, "ends") << " " << v.t_min << " " << v.t_max << " "
            << name_in(kUnits, v.unit, "unit") << " " << name_in(kCullings, v.culling, "culling")
            << "\n";
      return;
    default:
      give_up("no such roots: " + std::to_string(candidate.roots));
  }
}

/// Missing in libraries of version 1.
void introduce_contract(const raycheck_candidate& candidate, Reply& reply) {
  constexpr std::array<const char*, 4> kLevels = {nullptr, "ordinary", "demanding", "extreme"};
  if (candidate.level < 0 || candidate.level > 3) {
    give_up("no such level: " + std::to_string(candidate.level));
  }
  if (const char* const level = kLevels[static_cast<std::size_t>(candidate.level)]) {
    reply << "level " << level << "\n";
  }
  if (candidate.smallest_length != 0 || candidate.largest_length != 0) {
    reply << "lengths " << candidate.smallest_length << " " << candidate.largest_length << "\n";
  }
}

void introduce(const raycheck_candidate& candidate, Reply& reply) {
  reply << "raycheck 1 " << (candidate.name != nullptr ? candidate.name : "-") << "\n";
  const std::array<std::pair<const char*, bool>, 6> functions = {
      {{"frame", candidate.frame != nullptr},
       {"pixel_point", candidate.pixel_point != nullptr},
       {"pixel_ray", candidate.pixel_ray != nullptr},
       {"focal_ray", candidate.focal_ray != nullptr},
       {"intersect", candidate.intersect != nullptr || candidate.intersect_batch != nullptr},
       {"nearest", candidate.nearest != nullptr}}};
  for (const auto& [name, has] : functions) {
    if (has) reply << "function " << name << "\n";
  }
  const auto& d = candidate.declared;
  const std::array<std::int32_t, 5> declared = {d.rows, d.samples, d.origin, d.root, d.tangent};
  for (std::size_t k = 0; k < declared.size(); ++k) {
    const auto value = static_cast<std::size_t>(declared[k]);
    if (value == RAYCHECK_AS_ASKED) continue;
    if (value > 3 || kConventionNames[k][value] == nullptr) {
      give_up(std::string("no such ") + kConventions[k] + ": " + std::to_string(declared[k]));
    }
    reply << "convention " << kConventions[k] << " " << kConventionNames[k][value] << "\n";
  }
  if (candidate.version >= 2) introduce_contract(candidate, reply);
  if (candidate.version >= 3) {
    introduce_precision(candidate, reply);
    introduce_roots(candidate, reply);
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
  if (functions == nullptr) give_up("the library has no raycheck_candidate_functions()");
  const raycheck_candidate* const candidate = functions();
  if (candidate == nullptr) give_up("raycheck_candidate_functions() returns nothing");
  if (candidate->version < 1 || candidate->version > RAYCHECK_CANDIDATE_VERSION) {
    give_up("the library is for version " + std::to_string(candidate->version) +
            " of <raycheck/candidate.h>, this is for those up to " +
            std::to_string(RAYCHECK_CANDIDATE_VERSION));
  }
  return *candidate;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) give_up("usage: raycheck-worker LIBRARY.so");
  // Replies get a separate stream before any code of the library runs.
  const int replies = dup(STDOUT_FILENO);
  if (replies < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) give_up(std::strerror(errno));
  Reply reply(fdopen(replies, "w"));
  raycheck::tools::report_deaths(replies);
  const raycheck_candidate& candidate = load(argv[1]);
  Words words;
  if (!words.next_line() || words.word() != "raycheck") give_up("not spoken to by raycheck");
  introduce(candidate, reply);
  Request request;
  while (read_request(words, request)) {
    reply << "reply " << request.id << "\n";
    try {
      answer(candidate, request, reply);
      reply << "end " << request.id << "\n";
    } catch (const std::exception& error) {
      reply << raycheck::tools::frames_of_throw(error);
      reply << "error " << request.id << " " << error.what() << "\n";
    }
    reply.send();
  }
  return 0;
}
