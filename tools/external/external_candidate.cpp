#include "tools/external/external_candidate.h"

#include <fmt/core.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include "tools/external/candidate_spec.h"
#include "tools/methods/methods.h"

namespace raycheck::tools {

/// How a candidate failed to answer.
struct AnswerFailure {
  std::string words;
  FailureKind kind = FailureKind::kBadReply;

  [[noreturn]] void raise(const LastFailure& last) const {
    if (last) *last = kind;
    throw std::runtime_error(words);
  }
};

/// Pictures of the last scene, for all threads; a failure is kept like a picture.
class Pictures {
 public:
  explicit Pictures(Renderer renderer) : renderer_(std::move(renderer)) {}

  properties::ImageAnswer of(const scene::Scene& scene, scene::Rows rows, const LastFailure& last) {
    const std::lock_guard lock(mutex_);
    if (!scene_ || !(*scene_ == scene) || rows_ != rows) {
      scene_ = scene;
      rows_ = rows;
      draw(scene, rows);
    }
    if (failure_) failure_->raise(last);
    return picture_;
  }

 private:
  void draw(const scene::Scene& scene, scene::Rows rows) {
    failure_.reset();
    const auto fail = [this](const std::string& words, FailureKind kind) {
      failure_ = AnswerFailure{"image: " + words, kind};
      silences_ += kind == FailureKind::kTimeUp ? 1 : 0;
    };
    if (silences_ >= kMostSilences) {
      fail(fmt::format("not started, after {} times without an end", silences_),
           FailureKind::kEnded);
      return;
    }
    try {
      picture_ = render(renderer_, scene, rows);
    } catch (const ProcessFailure& failure) {
      fail(failure.what(), failure.kind());
    } catch (const std::exception& error) {
      fail(error.what(), FailureKind::kBadReply);
    }
  }

  Renderer renderer_;
  std::mutex mutex_;
  std::optional<scene::Scene> scene_;
  scene::Rows rows_ = {};
  properties::ImageAnswer picture_;
  std::optional<AnswerFailure> failure_;
  int silences_ = 0;
};

namespace {

using properties::Candidate;

/// A conversation with a process, which is replaced when it fails.
class Conversation {
 public:
  explicit Conversation(External external, LastFailure last = nullptr)
      : external_(std::move(external)), last_(std::move(last)) {}

  /// The reply to a request, read by `read`.
  template <class Read>
  auto ask(std::string_view function, const scene::Conventions& conventions, std::size_t lines,
           const std::function<void(Request&)>& fill, const Read& read) {
    Request request(next_id(), function, conventions);
    fill(request);
    if (silences_ >= kMostSilences) {
      AnswerFailure{
          fmt::format("{}: not asked, after {} requests without a reply", function, silences_),
          FailureKind::kEnded}
          .raise(last_);
    }
    if (failed_request_ == request.body()) failure_.raise(last_);
    try {
      const std::string text = exchange(request, lines);
      return read(Reply(text, request.id()));
    } catch (const ProcessFailure& failure) {
      silences_ += failure.kind() == FailureKind::kTimeUp ? 1 : 0;
      fail(request, {fmt::format("{}: it {}{}", function, failure.what(), last_line_text(said())),
                     failure.kind()});
    } catch (const ProtocolError& error) {
      fail(request, {fmt::format("{}: {}", function, error.what()), FailureKind::kBadReply});
    }
  }

  Introduction introduce() {
    start();
    return introduction_;
  }
  std::string said() const { return process_ ? process_->said() : ""; }

 private:
  /// Not to be foreseen, so that no reply is made before its request.
  std::string next_id() { return fmt::format("{:016x}", ids_()); }

  void start() {
    process_.emplace(external_.program);
    introduction_ = parse_introduction(process_->exchange(
        kGreeting, [](std::string_view line) { return line == kReady || line == "ready\r"; },
        kMostIntroduction));
  }

  std::string exchange(const Request& request, std::size_t lines) {
    if (!process_) start();
    return process_->exchange(
        request.text(), [&](std::string_view line) { return ends_reply(line, request.id()); },
        most_bytes(lines));
  }

  [[noreturn]] void fail(const Request& request, AnswerFailure failure) {
    process_.reset();
    failed_request_ = request.body();
    failure_ = std::move(failure);
    failure_.raise(last_);
  }

  External external_;
  LastFailure last_;
  std::optional<Process> process_;
  Introduction introduction_;
  std::string failed_request_;
  AnswerFailure failure_;
  int silences_ = 0;
  std::mt19937_64 ids_{std::random_device{}()};
};

Candidate rendering_candidate(const External& external, const LastFailure& last) {
  Candidate candidate;
  candidate.name = external.name;
  candidate.refuses = false;
  candidate.level = properties::Level::kOrdinary;
  candidate.excused_image_change = external.renderer->excused_change;
  candidate.image_threshold = external.renderer->threshold;
  candidate.image = [pictures = external.pictures, last](const scene::Scene& scene,
                                                         const scene::Conventions& conventions) {
    return pictures->of(scene, conventions.rows, last);
  };
  return candidate;
}

}  // namespace

External introduced(std::string name, const Confined& program,
                    std::shared_ptr<const PrivateFolder> folder) {
  External external{
      .name = std::move(name), .program = program, .introduction = {}, .folder = std::move(folder)};
  Conversation conversation(external);
  try {
    external.introduction = conversation.introduce();
  } catch (const ProcessFailure& failure) {
    throw CandidateError(
        fmt::format("it {}{}", failure.what(), last_line_text(conversation.said())));
  } catch (const ProtocolError& error) {
    throw CandidateError(error.what());
  }
  if (external.introduction.functions.empty()) {
    throw CandidateError("it offers no function");
  }
  return external;
}

External rendering(std::string name, Renderer renderer) {
  External external;
  external.name = std::move(name);
  external.program = renderer.program;
  external.pictures = std::make_shared<Pictures>(renderer);
  external.renderer = std::move(renderer);
  return external;
}

Candidate external_candidate(const External& external, const LastFailure& last) {
  if (external.renderer) return rendering_candidate(external, last);
  const auto talk = std::make_shared<Conversation>(external, last);
  const auto offers = [&](const char* function) {
    return external.introduction.functions.contains(function);
  };
  using Pixels = Candidate::Pixels;
  using Rays = Candidate::Rays;
  using Spheres = Candidate::Spheres;
  Candidate candidate;
  candidate.name = external.name;
  candidate.declared = external.introduction.declared;
  candidate.refuses = false;
  candidate.level = external.introduction.level.value_or(properties::Level::kOrdinary);
  const Candidate bounds = candidate_of(external.bounds);
  candidate.max_error = bounds.max_error;
  candidate.max_error_end_to_end = bounds.max_error_end_to_end;
  candidate.unit_roundoff = bounds.unit_roundoff;
  candidate.smallest_length =
      std::max(kSmallestJudgedLength, external.introduction.smallest_length);
  candidate.smallest_camera_length = candidate.smallest_length;
  candidate.largest_length = external.introduction.largest_length;
  if (offers("frame")) {
    candidate.frame = [talk](const scene::Camera& camera) {
      return talk->ask(
          "frame", {}, 3, [&](Request& request) { request.camera(camera); },
          [](const Reply& reply) { return reply.frame(); });
    };
  }
  if (offers("pixel_point")) {
    candidate.pixel_points = [talk](const scene::Camera& camera,
                                    const scene::Conventions& conventions, Pixels pixels) {
      return talk->ask(
          "pixel_point", conventions, pixels.size(),
          [&](Request& request) { request.camera(camera).pixels(pixels); },
          [&](const Reply& reply) { return reply.points(pixels.size()); });
    };
  }
  const auto make_rays = [talk](const char* function) {
    return [talk, function](const scene::Camera& camera, const scene::Conventions& conventions,
                            Pixels pixels) {
      return talk->ask(
          function, conventions, pixels.size(),
          [&](Request& request) { request.camera(camera).pixels(pixels); },
          [&](const Reply& reply) { return reply.rays(pixels.size()); });
    };
  };
  if (offers("pixel_ray")) candidate.pixel_rays = make_rays("pixel_ray");
  if (offers("focal_ray")) candidate.focal_rays = make_rays("focal_ray");
  if (offers("intersect")) {
    candidate.intersect = [talk](Rays rays, Spheres spheres,
                                 const scene::Conventions& conventions) {
      return talk->ask(
          "intersect", conventions, rays.size() * spheres.size(),
          [&](Request& request) { request.rays(rays).spheres(spheres); },
          [&](const Reply& reply) { return reply.hits(rays.size(), spheres.size()); });
    };
  }
  if (offers("nearest")) {
    candidate.nearest = [talk](Rays rays, Spheres spheres, const scene::Conventions& conventions) {
      return talk->ask(
          "nearest", conventions, rays.size(),
          [&](Request& request) { request.rays(rays).spheres(spheres); },
          [&](const Reply& reply) { return reply.nearest(rays.size(), spheres.size()); });
    };
  }
  return candidate;
}

}  // namespace raycheck::tools
