#include "tools/external/renderer.h"

#include <fmt/core.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "scene/number.h"

namespace raycheck::tools {
namespace {

namespace fs = std::filesystem;
using scene::Dialect;

constexpr const char* kSceneFile = "scene.txt";
constexpr const char* kImageFile = "image.ppm";

/// As many levels of a channel as give that many colours besides black.
int levels_for(std::size_t count) {
  int levels = 2;
  while (static_cast<std::size_t>(levels) * static_cast<std::size_t>(levels) *
                     static_cast<std::size_t>(levels) -
                 1 <
             count &&
         levels < 256) {
    ++levels;
  }
  return levels;
}

std::uint8_t channel(std::size_t level, int levels) {
  return static_cast<std::uint8_t>(std::lround(255.0 * static_cast<double>(level) / (levels - 1)));
}

/// The level of a channel; negative where it is near none.
int level_of(std::uint8_t value, int levels) {
  const double at = value / 255.0 * (levels - 1);
  const double nearest = std::round(at);
  return std::abs(at - nearest) <= 0.25 || levels > 128 ? static_cast<int>(nearest) : -1;
}

std::string read_made(const fs::path& path) {
  struct stat status {};
  if (lstat(path.c_str(), &status) != 0) throw std::runtime_error("it made no picture {image}");
  if (!S_ISREG(status.st_mode)) throw std::runtime_error("its picture {image} is no file");
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<Colour> id_colours(std::size_t count) {
  const int levels = levels_for(count);
  const auto base = static_cast<std::size_t>(levels);
  std::vector<Colour> colours;
  for (std::size_t k = 1; k <= count; ++k) {
    const std::size_t code = k % (base * base * base);
    colours.push_back({channel(code / base / base, levels), channel(code / base % base, levels),
                       channel(code % base, levels)});
  }
  return colours;
}

std::string driver_text(const scene::Scene& scene, Dialect dialect) {
  const scene::Camera& c = *scene.camera;
  const auto number = [](double x) { return scene::shortest(x); };
  const std::string near = number(dialect == Dialect::kA ? -c.near : c.near);
  std::string text = "# written by raycheck\n";
  if (dialect == Dialect::kC) {
    text += fmt::format("camera {} {} {} {}\n", scene::shortest_words(c.eye),
                        scene::shortest_words(c.look_at), scene::shortest_words(c.up), near);
  } else {
    text += fmt::format("eye {}\nlook {}\nup {}\nd {}\n", scene::shortest_words(c.eye),
                        scene::shortest_words(c.look_at), scene::shortest_words(c.up), near);
  }
  text += dialect == Dialect::kA ? fmt::format("bounds {} {} {} {}\n", number(c.left),
                                               number(c.bottom), number(c.right), number(c.top))
                                 : fmt::format("bounds {} {} {} {}\n", number(c.left),
                                               number(c.right), number(c.bottom), number(c.top));
  text += fmt::format("res {} {}\nambient 1 1 1\nlight 0 0 0 1 0 0 0\n", c.width, c.height);
  const auto colours = id_colours(scene.spheres.size());
  for (std::size_t k = 0; k < scene.spheres.size(); ++k) {
    const auto& [centre, radius] = scene.spheres[k];
    text += fmt::format("sphere {} {} {} {} {} 0 0 0 0 0 0 0 0 0\n", scene::shortest_words(centre),
                        number(radius), number(colours[k].red / 255.0),
                        number(colours[k].green / 255.0), number(colours[k].blue / 255.0));
  }
  return text;
}

properties::ImageAnswer image_answer(const ReadPicture& picture, const scene::Camera& camera,
                                     scene::Rows rows, std::size_t spheres) {
  if (picture.width != camera.width || picture.height != camera.height) {
    throw PictureError(fmt::format("its picture has {} x {} pixels, the scene {} x {}{}",
                                   picture.width, picture.height, camera.width, camera.height,
                                   picture.width == camera.height && picture.height == camera.width
                                       ? ": width and height are exchanged"
                                       : ""));
  }
  const int levels = levels_for(spheres);
  properties::ImageAnswer answer(picture.pixels.size());
  for (std::int64_t j = 0; j < camera.height; ++j) {
    const std::int64_t line = rows == scene::Rows::kTopFirst ? j : camera.height - 1 - j;
    for (std::int64_t i = 0; i < camera.width; ++i) {
      const Colour& colour = picture.pixels[static_cast<std::size_t>(line * camera.width + i)];
      if (colour == Colour{}) continue;
      std::size_t code = 0;
      bool is_known = true;
      for (const std::uint8_t value : {colour.red, colour.green, colour.blue}) {
        const int level = level_of(value, levels);
        is_known = is_known && level >= 0;
        code =
            code * static_cast<std::size_t>(levels) + static_cast<std::size_t>(std::max(0, level));
      }
      answer[static_cast<std::size_t>(j * camera.width + i)] =
          is_known && code >= 1 && code <= spheres ? code - 1 : properties::kSomeSphere;
    }
  }
  return answer;
}

properties::ImageAnswer render(const Renderer& renderer, const scene::Scene& scene,
                               scene::Rows rows) {
  Confined program = renderer.program;
  program.files = {{kSceneFile, driver_text(scene, renderer.dialect)}};
  for (std::string& word : program.arguments) {
    for (const auto& [mark, file] : {std::pair("{scene}", kSceneFile), {"{image}", kImageFile}}) {
      for (std::size_t at; (at = word.find(mark)) != std::string::npos;) {
        word.replace(at, std::string_view(mark).size(), file);
      }
    }
  }
  Process process(program);
  try {
    const int code = process.finish();
    if (code != 0) throw ProcessFailure(FailureKind::kEnded, fmt::format("exited with {}", code));
  } catch (const ProcessFailure& failure) {
    throw ProcessFailure(failure.kind(),
                         fmt::format("it {}{}", failure.what(), last_line_text(process.said())));
  }
  const ReadPicture picture = parse_picture(read_made(process.folder() / kImageFile),
                                            scene.camera->width * scene.camera->height * 64);
  return image_answer(picture, *scene.camera, rows, scene.spheres.size());
}

}  // namespace raycheck::tools
