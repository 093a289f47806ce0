#include "tools/external/pictures/renderer.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <ctime>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "properties/failures.h"
#include "tools/external/sandbox/file_tree.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Reads an ended program's file. `most`: the largest size of its files.
std::string read_made(const fs::path& path, std::uint64_t most) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
    throw PictureError("its picture {image} is no file");
  }
  // A picture that the program closed is not the machine's failure.
  chmod(path.c_str(), S_IRUSR | S_IWUSR);
  return file_bytes(path, most);
}

/// While it lives, this thread's CPU time is charged to the candidate.
class ComputedFor {
 public:
  explicit ComputedFor(SpentTime& spent) : spent_(spent), before_(computed()) {}
  ~ComputedFor() { spent_.add(computed() - before_); }
  ComputedFor(const ComputedFor&) = delete;
  ComputedFor& operator=(const ComputedFor&) = delete;

 private:
  static double computed() {
    constexpr double kNano = 1e-9;
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + kNano * static_cast<double>(time.tv_nsec);
  }
  SpentTime& spent_;
  double before_;
};

/// Runs the program.
MadePicture drawn(const Renderer& renderer, const std::string& driver, PictureSize size) {
  Confined program = renderer.program;
  program.files = {{kSceneFile, driver}};
  for (std::string& word : program.arguments) {
    boost::replace_all(word, "{scene}", kSceneFile);
    boost::replace_all(word, "{image}", kImageFile);
  }
  Process process(program);
  std::optional<ProcessFailure> failure;
  try {
    const int code = process.finish();
    if (code != 0) failure.emplace(FailureKind::kEnded, fmt::format("exited with {}", code));
  } catch (const ProcessFailure& thrown) {
    failure.emplace(thrown);
  }
  const auto found = found_picture(process.folder(), kImageFile, kSceneFile);
  const std::string said = process.excerpt();
  // A complete picture counts, however the program ended.
  if (found && (!failure || failure->kind() == FailureKind::kEnded)) {
    const ComputedFor reading(*program.spent);
    try {
      return {parse_picture(read_made(found->path, program.limits.file), kMostPicturePixels, size),
              found->is_named ? "" : found->path.filename().string(), failure ? failure->why() : "",
              said};
    } catch (const PictureError& error) {
      if (!failure) throw ProcessFailure(FailureKind::kBadReply, error.what(), said);
    }
  }
  if (failure) {
    throw ProcessFailure(
        failure->kind(),
        fmt::format("it {}{}", failure->why(), limit_text(process.said(), program.limits)), said);
  }
  throw ProcessFailure(FailureKind::kBadReply, "it made no picture {image}", said);
}

}  // namespace

std::string driver_text(const scene::Scene& scene, const DriverForm& form) {
  return driver_text(scene, form, SphereColours(scene.spheres.size()).all());
}

properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres,
                                     const ColourHabit& habit) {
  if (!picture.has_size({camera.width, camera.height})) {
    throw properties::OtherSize(
        fmt::format("its picture has {} x {} pixels, the scene {} x {}{}", picture.width,
                    picture.height, camera.width, camera.height,
                    picture.width == camera.height && picture.height == camera.width
                        ? ": width and height are exchanged"
                        : ""),
        picture.width, picture.height);
  }
  const SphereColours colours(spheres);
  properties::ImageAnswer answer(picture.pixels.size());
  for (std::int64_t j = 0; j < camera.height; ++j) {
    const std::int64_t line = rows == scene::Rows::kTopFirst ? j : camera.height - 1 - j;
    for (std::int64_t i = 0; i < camera.width; ++i) {
      const Colour& colour = picture.pixels[static_cast<std::size_t>(line * camera.width + i)];
      if (colour == habit.background) continue;
      answer[static_cast<std::size_t>(j * camera.width + i)] =
          colours.sphere_of(colour, habit).value_or(properties::kSomeSphere);
    }
  }
  return answer;
}

MadePicture rendered(const Renderer& renderer, const std::string& driver, PictureSize size) {
  const std::string request =
      fmt::format("within {} s\n{}", renderer.program.limits.seconds, driver);
  SpentTime& spent = *renderer.program.spent;
  if (const auto known = renderer.answers->find(request)) {
    spent.add(known->seconds);
    if (known->failure) {
      const std::size_t line = std::min(known->text.find('\n'), known->text.size());
      throw ProcessFailure(*known->failure, known->text.substr(0, line),
                           known->text.substr(std::min(line + 1, known->text.size())));
    }
    return stored_picture(known->text);
  }
  const double before = spent.seconds();
  const auto keep = [&](const std::string& text, std::optional<FailureKind> failure = {}) {
    renderer.answers->keep(request, {text, failure, spent.seconds() - before});
  };
  try {
    MadePicture made = drawn(renderer, driver, size);
    keep(stored_text(made));
    return made;
  } catch (const ProcessFailure& failure) {
    if (is_lasting(failure.kind())) keep(failure.why() + '\n' + failure.said(), failure.kind());
    throw;
  } catch (const std::system_error& error) {
    if (!is_of_the_machine(error.code())) {
      // The program made a folder or a picture unreadable.
      const std::string words = "its picture cannot be read: " + error.code().message();
      keep(words, FailureKind::kBadReply);
      throw ProcessFailure(FailureKind::kBadReply, words);
    }
    if (const auto& told = renderer.program.surroundings) told->blame(error.what());
    throw;
  }
}

properties::ImageAnswer render(const Renderer& renderer, const scene::Scene& scene,
                               scene::Rows rows) {
  const PictureSize size = {scene.camera->width, scene.camera->height};
  return image_answer(rendered(renderer, driver_text(scene, renderer.driver), size).picture,
                      *scene.camera, rows, scene.spheres.size(), renderer.colours);
}

}  // namespace raycheck::tools
