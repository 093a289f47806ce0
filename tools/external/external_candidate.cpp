#include "tools/external/external_candidate.h"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <iterator>
#include <mutex>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "contract/words.h"
#include "properties/failures.h"
#include "properties/interfaces.h"
#include "scene/text.h"
#include "tools/external/candidate_spec.h"
#include "tools/external/protocol/frames.h"
#include "tools/implementations/built_in.h"

namespace raycheck::tools {

/// How a candidate failed.
struct AnswerFailure {
  std::string words;
  FailureKind kind = FailureKind::kBadReply;
  std::optional<properties::OtherSize> size = {};  ///< The size of a picture, if it is wrong.
  bool fails_always = false;                       ///< Whether it fails on every request.
  std::optional<properties::CodeLine> line = {};   ///< The line in its source, if known.

  [[noreturn]] void raise(const LastFailure& last) const {
    if (last) *last = kind;
    if (size) throw properties::OtherSize(words, size->width, size->height);
    if (kind == FailureKind::kCannotExpress) throw properties::CannotBeSaid(words);
    if (fails_always || kind == FailureKind::kNotAsked || kind == FailureKind::kSystem) {
      throw properties::CandidateUnavailable(words);
    }
    throw properties::CandidateFailed(words, line, kind == FailureKind::kTimeUp);
  }
};

/// The latest pictures of a renderer. All threads share them, and draw different scenes in
/// parallel. Failures are kept like pictures.
class Pictures {
 public:
  explicit Pictures(Renderer renderer) : renderer_(std::move(renderer)) {}

  DrawnImage of(const scene::Scene& scene, const scene::Conventions& conventions,
                const LastFailure& last) {
    const std::shared_ptr<Picture> picture = kept(scene, conventions);
    std::call_once(picture->drawn, [&] { draw(*picture); });
    if (picture->failure) picture->failure->raise(last);
    return picture->image;
  }

 private:
  struct Picture {
    scene::Scene scene;
    scene::Conventions conventions;
    std::once_flag drawn = {};
    DrawnImage image = {};
    std::optional<AnswerFailure> failure = {};
    std::int64_t pixels() const { return scene.camera->width * scene.camera->height; }
  };
  /// The limits on the number and the total pixels of kept pictures. The last picture is always
  /// kept.
  static constexpr std::ptrdiff_t kKept = 32;
  static constexpr std::int64_t kKeptPixels = std::int64_t{1} << 22;

  /// The entry for a scene, made if it does not exist, and moved to the end.
  std::shared_ptr<Picture> kept(const scene::Scene& scene, const scene::Conventions& conventions) {
    const std::lock_guard lock(mutex_);
    auto found = std::ranges::find_if(kept_, [&](const auto& one) {
      return one->conventions == conventions && one->scene == scene;
    });
    if (found == kept_.end()) {
      kept_.push_back(std::shared_ptr<Picture>(new Picture{scene, conventions}));
      found = std::prev(kept_.end());
    }
    std::rotate(found, std::next(found), kept_.end());
    std::int64_t pixels = 0;
    auto first = kept_.end();
    while (first != kept_.begin() && pixels <= kKeptPixels && kept_.end() - first < kKept) {
      pixels += (*--first)->pixels();
    }
    kept_.erase(kept_.begin(), first);
    return kept_.back();
  }

  void draw(Picture& picture) {
    const auto fail = [&](const std::string& words, FailureKind kind) {
      picture.failure =
          AnswerFailure{kind == FailureKind::kCannotExpress ? words : "image: " + words, kind};
      timeouts_ += kind == FailureKind::kTimeUp ? 1 : 0;
    };
    if (const int timeouts = timeouts_; timeouts >= renderer_.most_timeouts) {
      fail(fmt::format("not started any more, since {} runs timed out", timeouts),
           FailureKind::kNotAsked);
      return;
    }
    try {
      picture.image = render(renderer_, picture.scene, picture.conventions);
    } catch (const ProcessFailure& failure) {
      fail(failure.what(), failure.kind());
    } catch (const properties::CannotBeSaid& error) {
      fail(error.what(), FailureKind::kCannotExpress);
    } catch (const properties::OtherSize& error) {
      fail(error.what(), FailureKind::kBadReply);
      picture.failure->size = error;
    } catch (const PictureError& error) {
      fail(error.what(), FailureKind::kBadReply);
    } catch (const std::system_error& error) {
      fail(error.what(), FailureKind::kSystem);
    }
  }

  Renderer renderer_;
  std::mutex mutex_;
  std::vector<std::shared_ptr<Picture>> kept_;  ///< The most recently used picture is last.
  std::atomic<int> timeouts_ = 0;
};

namespace {

using properties::Candidate;
using properties::CodeLine;

/// " at tracer.cpp:42", as a clause; empty if the line is unknown.
std::string line_text(const std::optional<CodeLine>& line) {
  return line ? fmt::format(" at {}:{}", scene::visible_line(line->file), line->line) : "";
}

/// A conversation with a process, which is replaced when it fails.
class Conversation {
 public:
  explicit Conversation(External external, LastFailure last = nullptr)
      : external_(std::move(external)), last_(std::move(last)) {}

  /// Sends a request; `read` parses the reply.
  template <class Read>
  auto ask(std::string_view function, const scene::Conventions& conventions, std::size_t lines,
           const std::function<void(Request&)>& fill, const Read& read) {
    return properties::asked_by_us(
        [&] { return read_reply(function, conventions, lines, fill, read); });
  }

  Introduction introduce() {
    if (const auto known = external_.answers->find(std::string(kGreeting))) {
      return parse_introduction(known->text);
    }
    start();
    return introduction_;
  }
  /// Sets the share of the reply time limit for the next requests.
  void allow(double share) { share_ = share; }
  /// Resets the count of time-outs, and uses stored answers again.
  void reset_timeouts() {
    shares_timed_out_ = 0;
    failed_request_.clear();
    is_asked_anew_ = false;
  }
  /// Makes the next requests go to a fresh process, and ignores stored answers.
  void restart() {
    reset_timeouts();
    process_.reset();
    is_asked_anew_ = true;
  }
  KeptText error_output() const { return process_ ? process_->error_output() : KeptText(); }

 private:
  template <class Read>
  auto read_reply(std::string_view function, const scene::Conventions& conventions,
                  std::size_t lines, const std::function<void(Request&)>& fill, const Read& read) {
    Request request(next_id(), function, conventions);
    fill(request);
    if (shares_timed_out_ >= kMostTimeouts) {
      AnswerFailure{
          fmt::format(
              "{}: not called any more, since its time-outs add up to {} times the limit; the "
              "last: {}",
              function, kMostTimeouts, failure_.words),
          FailureKind::kNotAsked}
          .raise(last_);
    }
    if (failed_request_ == request.body()) failure_.raise(last_);
    const SpentTime::Time before = external_.program.spent->so_far();
    IdentifiedReply reply;
    try {
      reply = reply_to(request, lines);
      return read(Reply(reply.text, reply.id));
    } catch (const ProcessFailure& failure) {
      if (failure.kind() == FailureKind::kTimeUp) {
        shares_timed_out_ += share_ * (process_ ? process_->limits_waited() : 1);
      }
      const auto line = line_in(process_ ? process_->unfinished() : "");
      AnswerFailure words{fmt::format("{}: it {}{}{}{}", function, failure.what(), line_text(line),
                                      last_line_text(error_output()),
                                      limit_text(error_output(), external_.program.limits)),
                          failure.kind(),
                          {},
                          !introduction_heard_,
                          line};
      if (is_lasting(words.kind) && !is_asked_anew_) {
        external_.answers->keep(request.body(), {words.words, words.kind,
                                                 external_.program.spent->seconds_since(before)});
      }
      fail(request, std::move(words));
    } catch (const ProtocolError& error) {
      const auto line = line_in(reply.text);
      fail(request, {fmt::format("{}: {}{}", function, error.what(), line_text(line)),
                     FailureKind::kBadReply,
                     {},
                     !introduction_heard_,
                     line});
    }
  }

  /// An unpredictable id, so that no reply can be prepared in advance.
  std::string next_id() { return fmt::format("{:016x}", ids_()); }

  void start() {
    introduction_heard_ = false;
    process_.emplace(external_.program);
    // A program that begins with other output is not waited for.
    std::optional<std::string> first;
    std::string text;
    try {
      text = process_->exchange(
          kGreeting,
          [&](std::string_view line) {
            if (!first) first = line;
            return !begins_introduction(*first) || line == kReady || line == "ready\r";
          },
          kMostIntroduction);
    } catch (const ProcessFailure&) {
      if (!first || begins_introduction(*first)) throw;
    }
    if (first && !begins_introduction(*first)) {
      throw ProtocolError(fmt::format(
          "its first line is '{}', not 'raycheck 1 NAME'; print only replies to standard "
          "output, and other text to standard error",
          contract::shown(*first)));
    }
    introduction_ = parse_introduction(text);
    introduction_heard_ = true;
    external_.answers->keep(std::string(kGreeting), {text});
  }

  /// The source line of a crash or exception that the worker reports.
  std::optional<CodeLine> line_in(std::string_view answer) const {
    return external_.lines ? external_.lines->innermost(frames_in(answer)) : std::nullopt;
  }

  /// A reply, and the id of its request.
  struct IdentifiedReply {
    std::string id, text;
  };

  IdentifiedReply reply_to(const Request& request, std::size_t lines) {
    if (const auto known = kept_answer(request)) {
      external_.program.spent->add(known->seconds);
      if (known->failure) AnswerFailure{known->text, *known->failure}.raise(last_);
      const std::size_t line = known->text.find('\n');
      return {known->text.substr(0, line), known->text.substr(line + 1)};
    }
    if (!process_) start();
    process_->allow(share_ * external_.program.limits.seconds);
    const SpentTime::Time before = external_.program.spent->so_far();
    std::string text = process_->exchange(
        request.text(), [&](std::string_view line) { return ends_reply(line, request.id()); },
        most_bytes(lines));
    if (!is_asked_anew_) {
      external_.answers->keep(
          request.body(),
          {request.id() + "\n" + text, {}, external_.program.spent->seconds_since(before)});
    }
    return {request.id(), std::move(text)};
  }

  std::optional<StoredAnswer> kept_answer(const Request& request) const {
    return is_asked_anew_ ? std::nullopt : external_.answers->find(request.body());
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
  bool introduction_heard_ = true;  ///< Whether the introduction of the current process was read.
  double share_ = 1;
  bool is_asked_anew_ = false;
  /// The sum of their shares of the time limit, each times the limits that it waited.
  double shares_timed_out_ = 0;
  std::mt19937_64 ids_{std::random_device{}()};
};

Candidate rendering_candidate(const External& external, const LastFailure& last) {
  Candidate candidate;
  candidate.name = external.name;
  candidate.refuses = false;
  candidate.level = properties::Level::kOrdinary;
  candidate.excused_image_change = external.renderer->excused_change;
  candidate.image_threshold = external.renderer->threshold;
  candidate.any_sample = external.renderer->any_sample;
  candidate.interface = external.introduction.declared.interface;
  candidate.declared = external.introduction.declared.conventions;
  candidate.image = [pictures = external.pictures, last](const scene::Scene& scene,
                                                         const scene::Conventions& conventions) {
    return properties::asked_by_us([&] { return pictures->of(scene, conventions, last).spheres; });
  };
  if (external.renderer->depth) {
    candidate.depth = external.renderer->depth->depth;
    candidate.depths = [pictures = external.pictures, last](const scene::Scene& scene,
                                                            const scene::Conventions& conventions) {
      return properties::asked_by_us([&] { return pictures->of(scene, conventions, last).depths; });
    };
  }
  return judged_in(external.precision, std::move(candidate));
}

/// Sets the functions that the candidate implements.
void add_functions(const std::shared_ptr<Conversation>& talk,
                   const std::set<std::string>& functions, Candidate& candidate) {
  const auto of_pixels = [talk](const char* function, auto answers) {
    return [=](const scene::Camera& camera, const scene::Conventions& conventions,
               Candidate::Pixels pixels) {
      return talk->ask(
          function, conventions, pixels.size(),
          [&](Request& request) { request.camera(camera).pixels(pixels); },
          [&](const Reply& reply) { return (reply.*answers)(pixels.size()); });
    };
  };
  const auto of_rays = [talk](const char* function, auto answers) {
    return [=](Candidate::Rays rays, Candidate::Spheres spheres,
               const scene::Conventions& conventions) {
      return talk->ask(
          function, conventions, rays.size() * spheres.size(),
          [&](Request& request) { request.rays(rays).spheres(spheres); },
          [&](const Reply& reply) { return (reply.*answers)(rays.size(), spheres.size()); });
    };
  };
  if (functions.contains("frame")) {
    candidate.frame = [talk](const scene::Camera& camera) {
      return talk->ask(
          "frame", {}, 3, [&](Request& request) { request.camera(camera); },
          [](const Reply& reply) { return reply.frame(); });
    };
  }
  if (functions.contains("pixel_point")) {
    candidate.pixel_points = of_pixels("pixel_point", &Reply::points);
  }
  if (functions.contains("pixel_ray")) {
    candidate.pixel_rays = of_pixels("pixel_ray", &Reply::rays);
  }
  if (functions.contains("focal_ray")) {
    candidate.focal_rays = of_pixels("focal_ray", &Reply::rays);
  }
  if (functions.contains("intersect")) {
    candidate.intersect = of_rays("intersect", &Reply::hits);
  }
  if (functions.contains("pick")) {
    candidate.pick = [talk](const scene::Camera& camera, const scene::Conventions& conventions,
                            Candidate::Pixels pixels, Candidate::Spheres spheres) {
      return talk->ask(
          "pick", conventions, pixels.size() * spheres.size(),
          [&](Request& request) { request.camera(camera).pixels(pixels).spheres(spheres); },
          [&](const Reply& reply) { return reply.hits(pixels.size(), spheres.size()); });
    };
  }
  if (functions.contains("nearest")) candidate.nearest = of_rays("nearest", &Reply::nearest);
}

/// What the format of its scene files implies; the scene says the rest.
Introduction introduction_of(const Renderer& renderer) {
  Introduction introduction;
  contract::DeclaredConventions& conventions = introduction.declared.conventions = {};
  const scene::FileFormat& format = *renderer.driver.format;
  if (format.is_of_programs) {
    conventions.rows = format.rows;
    conventions.samples = format.samples;
    conventions.origin = format.origin;
  }
  if (format.has_angle()) {
    introduction.declared.interface.windows = contract::Windows::kSquarePixels;
  }
  return introduction;
}

/// Requires that two declarations differ only in what pictures show.
void require_shown(contract::Declarations before, const contract::Declarations& declared) {
  const auto rows = std::exchange(before.conventions, declared.conventions).rows;
  before.conventions.rows = rows;  // the first row of a picture is always its top
  before.interface.windows = declared.interface.windows;
  if (contract::statements(before) != contract::statements(declared)) {
    throw std::invalid_argument(
        "of a renderer, which has no functions, only windows and conventions of pictures can be "
        "declared: samples, origin, root, tangent, roots, and the parts of roots");
  }
}

}  // namespace

External introduced(std::string name, const Confined& program,
                    std::shared_ptr<const PrivateFolder> folder,
                    std::shared_ptr<AnswerStore> answers) {
  External external{.name = std::move(name),
                    .program = program,
                    .introduction = {},
                    .folder = std::move(folder),
                    .answers = std::move(answers)};
  Conversation conversation(external);
  try {
    external.introduction = conversation.introduce();
    external.precision = external.introduction.declared.precision;
  } catch (const ProcessFailure& failure) {
    const KeptText error_output = conversation.error_output();
    const std::string all = error_output.excerpt();
    // raycheck-worker names what a library lacks.
    constexpr std::string_view kOfWorker = "; it printed: raycheck-worker: ";
    const std::string printed = last_line_text(error_output);
    if (printed.starts_with(kOfWorker)) throw CandidateError(printed.substr(kOfWorker.size()));
    const bool is_silent = failure.kind() == FailureKind::kEnded && error_output.empty();
    throw CandidateError(
        fmt::format("it {}{}{}{}", failure.what(),
                    is_silent ? " before it printed 'raycheck 1 NAME'; a program that uses "
                                "raycheck_candidate must end with a call of run()"
                              : "",
                    printed, limit_text(error_output, program.limits)),
        all.find('\n') == std::string::npos ? "" : all);
  } catch (const ProtocolError& error) {
    throw CandidateError(error.what());
  }
  if (external.introduction.functions.empty()) {
    throw CandidateError("it has none of the functions that raycheck judges");
  }
  return external;
}

void declare_over(std::string_view statements, External& external) {
  if (statements.empty()) return;
  contract::Declarations declared = external.introduction.declared;
  contract::declare_all(statements, declared);
  if (external.renderer) {
    require_shown(external.introduction.declared, declared);
  } else if (declared.interface.returns != external.introduction.declared.interface.returns) {
    throw std::invalid_argument("what functions return must be declared in their code");
  }
  if (const auto wrong = contract::defects(declared); !wrong.empty()) {
    throw std::invalid_argument(scene::sentences(wrong));
  }
  if (!external.renderer) external.precision = declared.precision;
  external.introduction.declared = declared;
  external.declares = statements;
}

External rendering(std::string name, Renderer renderer) {
  External external;
  external.introduction = introduction_of(renderer);
  external.name = std::move(name);
  external.program = renderer.program;
  external.pictures = std::make_shared<Pictures>(renderer);
  external.renderer = std::move(renderer);
  return external;
}

External reading(const External& renderer, const DriverForm& driver) {
  External external = renderer;
  external.renderer->driver = driver;
  external.introduction = introduction_of(*external.renderer);
  external.pictures = std::make_shared<Pictures>(*external.renderer);
  declare_over(renderer.declares, external);
  return external;
}

Candidate external_candidate(const External& external, const LastFailure& last) {
  if (external.renderer) return rendering_candidate(external, last);
  const auto talk = std::make_shared<Conversation>(external, last);
  Candidate candidate = properties::declaring(external.introduction.declared, external.name,
                                              candidate_of(external.bounds));
  candidate.allow = [talk](double share) { talk->allow(share); };
  candidate.reset_timeouts = [talk] { talk->reset_timeouts(); };
  candidate.restart = [talk] { talk->restart(); };
  add_functions(talk, external.introduction.functions, candidate);
  static_cast<properties::Functions&>(candidate) =
      adapted(static_cast<const properties::Functions&>(candidate),
              external.introduction.declared.interface, external.precision);
  return judged_in(external.precision, std::move(candidate));
}

}  // namespace raycheck::tools
