#include "tools/external/pictures/renderer.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <ctime>
#include <sstream>
#include <string_view>
#include <system_error>
#include <tuple>

#include "properties/failures.h"
#include "properties/mistakes/shown_picture.h"
#include "scene/number.h"
#include "scene/text.h"
#include "tools/external/pictures/other_formats.h"
#include "tools/external/sandbox/file_tree.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;

/// Reads a picture after the program has ended. `most`: the program's limit on file sizes.
std::string read_made(const fs::path& path, std::uint64_t most) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
    throw PictureError(fmt::format("its picture {} is not a file", kImageFile));
  }
  // If the program made the file unreadable, the machine is not at fault.
  chmod(path.c_str(), S_IRUSR | S_IWUSR);
  return file_bytes(path, most);
}

/// While it exists, this thread's CPU time is charged to the candidate.
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

/// Stems of picture names, in order of preference: those from the driver file's name, then common
/// names.
constexpr std::array<std::string_view, 7> kStems = {"scene", "scene.txt", "out",   "output",
                                                    "image", "picture",   "result"};

/// A picture that a program made, and whether it has the requested name.
struct FoundPicture {
  std::filesystem::path path;
  bool is_named = true;
};

/// The picture in a program's folder, which contained no pictures before: the file with the
/// requested name; if there is none, one with a stem in kStems; otherwise the newest. Only names of
/// pictures count, and no links. Empty if there is no picture.
std::optional<FoundPicture> found_picture(const fs::path& folder) {
  const fs::path named = folder / kImageFile;
  if (fs::exists(fs::symlink_status(named))) return FoundPicture{named, true};
  struct Found {
    std::ptrdiff_t rank;
    fs::file_time_type made;
    fs::path path;
  };
  std::vector<Found> pictures;
  // The program may have made its folders unreadable.
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code gone;
    if (!fs::is_regular_file(entry->symlink_status(gone)) ||
        !is_picture_name(entry->path().string())) {
      continue;
    }
    const auto* const stem =
        std::ranges::find(kStems, boost::to_lower_copy(entry->path().stem().string()));
    pictures.push_back({stem - kStems.begin(), entry->last_write_time(gone), entry->path()});
  }
  if (pictures.empty()) return {};
  const auto best = std::ranges::min_element(pictures, [](const Found& a, const Found& b) {
    return std::tuple(a.rank, b.made, a.path) < std::tuple(b.rank, a.made, b.path);
  });
  return FoundPicture{best->path, false};
}

/// Serialises a picture for the answer store, and reads it back.
std::string stored_text(const MadePicture& made) {
  const auto& [width, height, pixels, is_lossy, unclear, depths] = made.picture;
  std::string text = fmt::format("{} {} {} {} {} {} {} {}\n", width, height, is_lossy ? 1 : 0,
                                 made.other_name.size(), made.ended.size(), pixels.size(),
                                 unclear.size(), depths.size());
  const auto add = [&](const auto& from) {
    text.append(reinterpret_cast<const char*>(from.data()), from.size() * sizeof(from[0]));
  };
  add(made.other_name), add(made.ended), add(pixels), add(unclear), add(depths);
  return text;
}

MadePicture stored_picture(const std::string& text) {
  std::istringstream stored(text);
  MadePicture made;
  std::size_t other_name = 0, ended = 0, pixels = 0, unclear = 0, depths = 0;
  stored >> made.picture.width >> made.picture.height >> made.picture.is_lossy >> other_name >>
      ended >> pixels >> unclear >> depths;
  stored.get();
  const auto take = [&](auto& into, std::size_t size) {
    into.resize(size);
    stored.read(reinterpret_cast<char*>(into.data()),
                static_cast<std::streamsize>(size * sizeof(into[0])));
  };
  take(made.other_name, other_name);
  take(made.ended, ended);
  take(made.picture.pixels, pixels);
  take(made.picture.unclear, unclear);
  take(made.picture.depths, depths);
  return made;
}

/// A scene file, and the size of its picture.
struct SceneFile {
  std::string name;
  const std::string& text;
  PictureSize size;
};

/// The program with the scene file in its folder; the names of the files and the size of the
/// picture are in its arguments.
Confined given(Confined program, const SceneFile& scene) {
  program.files = {{scene.name, scene.text}};
  for (std::string& word : program.arguments) {
    boost::replace_all(word, "{scene}", scene.name);
    boost::replace_all(word, "{image}", kImageFile);
    boost::replace_all(word, "{width}", std::to_string(scene.size.width));
    boost::replace_all(word, "{height}", std::to_string(scene.size.height));
  }
  return program;
}

/// Whether the wrapper exits with kCannotExpress for this driver file, too.
bool cannot_say(const std::optional<Confined>& wrapper, const SceneFile& scene) try {
  return wrapper && Process(given(*wrapper, scene)).finish() == kCannotExpress;
} catch (const ProcessFailure& failure) {
  if (failure.kind() == FailureKind::kSystem) throw;
  return false;
}

MadePicture picture_by(const Renderer& renderer, const std::string& driver, PictureSize size) {
  const SceneFile scene = {renderer.driver.file_name(), driver, size};
  const Confined program = given(renderer.program, scene);
  Process process(program);
  std::optional<ProcessFailure> failure;
  int code = 0;
  try {
    code = process.finish();
    if (code != 0) failure.emplace(FailureKind::kEnded, fmt::format("exited with {}", code));
  } catch (const ProcessFailure& thrown) {
    failure.emplace(thrown);
  }
  const auto found = found_picture(process.folder());
  const std::string said = process.excerpt();
  // A complete picture counts even if the program ended with an error.
  if (found && (!failure || failure->kind() == FailureKind::kEnded)) {
    const ComputedFor reading(*program.spent);
    try {
      return {read_picture(read_made(found->path, program.limits.file), program, size,
                           renderer.colours.background),
              found->is_named ? "" : found->path.filename().string(), failure ? failure->why() : "",
              said};
    } catch (const PictureError& error) {
      if (!failure) throw ProcessFailure(FailureKind::kBadReply, error.what(), said);
    }
  }
  if (code == kCannotExpress && cannot_say(renderer.wrapper, scene)) {
    throw ProcessFailure(FailureKind::kCannotExpress, "its input format cannot express the scene");
  }
  if (failure) {
    throw ProcessFailure(
        failure->kind(),
        fmt::format("it {}{}", failure->why(), limit_text(process.error_output(), program.limits)),
        said);
  }
  const std::string missing =
      renderer.is_told_name() ? fmt::format("its picture, {}", kImageFile) : "a picture";
  throw ProcessFailure(FailureKind::kBadReply,
                       fmt::format("it exited with 0, but did not write {}{}", missing,
                                   limit_text(process.error_output(), program.limits)),
                       said);
}

/// Makes the pixels of a depth picture white where it shows a sphere, and black elsewhere.
MadePicture with_pixels_of(const DepthForm& form, MadePicture made) {
  ReadPicture& picture = made.picture;
  if (picture.depths.size() != picture.pixels.size()) {
    throw ProcessFailure(
        FailureKind::kBadReply,
        "its depth picture is not a PFM, the one format read here that keeps floats");
  }
  std::ranges::transform(picture.depths, picture.pixels.begin(), [&](float number) {
    return form.is_miss(number) ? Colour{} : Colour{255, 255, 255};
  });
  return made;
}

}  // namespace

std::string DepthForm::text() const {
  return fmt::format("{} miss {}", properties::kDepthNames[static_cast<std::size_t>(depth)], miss);
}

DepthForm depth_form(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string name, word, miss = "inf", more;
  words >> name;
  const bool has_miss = static_cast<bool>(words >> word);
  if (has_miss && !(words >> miss)) miss.clear();
  const auto& names = properties::kDepthNames;
  const auto* const found = std::ranges::find(names, name);
  const auto number = scene::parse_number(miss);
  if (found == names.end() || !number || (has_miss && word != "miss") || (words >> more)) {
    throw std::invalid_argument(
        fmt::format("must be {}, and may be followed by 'miss VALUE', as in 'z miss 0'",
                    scene::joined(names, " or ")));
  }
  return {static_cast<properties::Depth>(found - names.begin()), static_cast<float>(*number)};
}

bool Renderer::is_told_name() const {
  return std::ranges::any_of(program.arguments, [](const std::string& word) {
    return word.find("{image}") != std::string::npos;
  });
}

std::string driver_text(const scene::Scene& scene, const DriverForm& form,
                        const ColourHabit& habit) {
  const std::size_t count = scene.spheres.size();
  return driver_text(scene, form,
                     habit.tells_spheres ? SphereColours(count).all()
                                         : std::vector<Colour>(count, {255, 255, 255}));
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
  std::vector<std::vector<ShownPixel>> shown(spheres);
  for (std::int64_t j = 0; j < camera.height; ++j) {
    const std::int64_t line = rows == scene::Rows::kTopFirst ? j : camera.height - 1 - j;
    for (std::int64_t i = 0; i < camera.width; ++i) {
      const auto from = static_cast<std::size_t>(line * camera.width + i);
      const auto at = static_cast<std::size_t>(j * camera.width + i);
      const Colour& colour = picture.pixels[from];
      if (std::ranges::binary_search(picture.unclear, from)) {
        answer[at] = properties::kUnclear;
        continue;
      }
      if (colour == habit.background) continue;
      answer[at] = properties::kSomeSphere;
      const bool is_mixed = std::min({colour.red, colour.green, colour.blue}) > 0;
      if (picture.is_lossy && (is_mixed || spheres > kMostSaturated)) continue;
      if (const auto sphere = colours.sphere_of(colour, habit))
        shown[*sphere].push_back({at, colour});
    }
  }
  colours.keep_usual(shown);
  for (std::size_t sphere = 0; sphere < spheres; ++sphere) {
    for (const ShownPixel& pixel : shown[sphere]) answer[pixel.at] = sphere;
  }
  return answer;
}

namespace {

/// The picture as the program makes it, or the stored one.
MadePicture made_or_stored(const Renderer& renderer, const std::string& driver, PictureSize size,
                           int nth) {
  const std::string request =
      fmt::format("{}{} x {} within {} s\n{}", nth > 1 ? fmt::format("{}: ", nth) : "", size.width,
                  size.height, renderer.program.limits.seconds, driver);
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
  const SpentTime::Time before = spent.so_far();
  const auto keep = [&](const std::string& text, std::optional<FailureKind> failure = {}) {
    renderer.answers->keep(request, {text, failure, spent.seconds_since(before)});
  };
  try {
    MadePicture made = picture_by(renderer, driver, size);
    keep(stored_text(made));
    return made;
  } catch (const ProcessFailure& failure) {
    if (is_lasting(failure.kind())) keep(failure.why() + '\n' + failure.output(), failure.kind());
    throw;
  } catch (const std::system_error& error) {
    if (!is_of_the_machine(error.code())) {
      // The program made a folder or the picture unreadable.
      const std::string words = "its picture cannot be read: " + error.code().message();
      keep(words, FailureKind::kBadReply);
      throw ProcessFailure(FailureKind::kBadReply, words);
    }
    if (const auto& surroundings = renderer.program.surroundings) surroundings->blame(error.what());
    throw;
  }
}

/// JPEG may lose parts of a picture that are narrower or lower than this many pixels.
constexpr std::int64_t kWide = 3;

/// Makes wrong pixels unclear that are in no square of kWide x kWide pixels of the same sphere, or
/// of the background, in the exact image.
void doubt_narrow_parts(const properties::ImageAnswer& exact, std::int64_t width,
                        properties::ImageAnswer& answer) {
  const std::int64_t height = std::ssize(exact) / width;
  std::vector<bool> is_wide(exact.size());
  const auto all_of_square = [&](std::int64_t first, const auto& is) {
    for (std::int64_t k = 0; k < kWide * kWide; ++k) {
      if (!is(static_cast<std::size_t>(first + k / kWide * width + k % kWide))) return false;
    }
    return true;
  };
  for (std::int64_t y = 0; y + kWide <= height; ++y) {
    for (std::int64_t x = 0; x + kWide <= width; ++x) {
      const std::int64_t first = y * width + x;
      const auto& shown = exact[static_cast<std::size_t>(first)];
      if (!all_of_square(first, [&](std::size_t k) { return exact[k] == shown; })) continue;
      all_of_square(first, [&](std::size_t k) { return is_wide[k] = true; });
    }
  }
  for (std::size_t k = 0; k < answer.size(); ++k) {
    const bool is_as = answer[k] == exact[k] || (answer[k] == properties::kSomeSphere && exact[k]);
    if (!is_as && !is_wide[k]) answer[k] = properties::kUnclear;
  }
}

}  // namespace

MadePicture rendered(const Renderer& renderer, const std::string& driver, PictureSize size,
                     int nth) {
  MadePicture made = made_or_stored(renderer, driver, size, nth);
  return renderer.depth ? with_pixels_of(*renderer.depth, std::move(made)) : made;
}

DrawnImage render(const Renderer& renderer, const scene::Scene& scene,
                  const scene::Conventions& conventions) {
  const PictureSize size = {scene.camera->width, scene.camera->height};
  const std::string why = scene::why_not_expressed(*renderer.driver.format, scene);
  if (!why.empty()) throw ProcessFailure(FailureKind::kCannotExpress, why);
  const std::string driver = driver_text(scene, renderer.driver, renderer.colours);
  ReadPicture picture = rendered(renderer, driver, size).picture;
  properties::ImageAnswer answer = image_answer(picture, *scene.camera, conventions.rows,
                                                scene.spheres.size(), renderer.colours);
  if (picture.is_lossy) {
    doubt_narrow_parts(properties::exact_image(scene, conventions), size.width, answer);
  }
  if (!renderer.depth) return {std::move(answer), {}};
  if (conventions.rows == scene::Rows::kBottomFirst) {
    std::vector<float> turned;
    for (auto row = picture.depths.end(); row != picture.depths.begin(); row -= size.width) {
      turned.insert(turned.end(), row - size.width, row);
    }
    picture.depths = std::move(turned);
  }
  return {std::move(answer), std::move(picture.depths)};
}

}  // namespace raycheck::tools
