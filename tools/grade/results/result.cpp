#include "tools/grade/results/result.h"

#include <optional>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tools/external/pictures/renderer.h"
#include "tools/external/sandbox/private_folder.h"
#include "tools/grade/results/record.h"

namespace raycheck::tools {

properties::Candidate tolerated(properties::Candidate candidate, const Tolerance& tolerance) {
  const double unit = scene::unit_roundoff(candidate.precision);
  if (tolerance.conditioning) {
    candidate.max_error.fill(properties::kModerateCondition * *tolerance.conditioning);
    candidate.max_error_end_to_end.fill({});
    candidate.unit_roundoff = unit * *tolerance.conditioning;
  } else if (tolerance.ulp) {
    candidate.unit_roundoff = unit * *tolerance.ulp / properties::kExcusedRoundoffs;
  }
  return candidate;
}

std::string plain_text(const std::string& said) {
  // Quotes as compilers print them.
  static const std::regex quotes("\xe2\x80[\x98\x99]");
  std::string text = std::regex_replace(without_private_folders(said), quotes, "'");
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < ' ' && c != '\n' && c != '\t') || byte > '~') c = '?';
  }
  return text;
}

std::string runs_of(const properties::ImageAnswer& image) {
  std::string text;
  for (std::size_t k = 0, count = 1; k < image.size(); k += count, count = 1) {
    while (k + count < image.size() && image[k + count] == image[k]) ++count;
    text += (text.empty() ? "" : " ") + std::to_string(count) + "x";
    if (!image[k]) {
      text += "-";
    } else {
      text += *image[k] == properties::kSomeSphere ? "?" : std::to_string(*image[k]);
    }
  }
  return text;
}

properties::ImageAnswer image_of(const std::string& runs) {
  std::istringstream words(runs);
  properties::ImageAnswer image;
  std::size_t count = 0;
  char x = 0;
  for (std::string shown; words >> count >> x >> shown;) {
    constexpr auto kMost = static_cast<std::size_t>(kMostPicturePixels);
    if (count > kMost - image.size()) throw std::invalid_argument("too many pixels");
    std::optional<std::size_t> sphere;
    if (shown == "?") {
      sphere = properties::kSomeSphere;
    } else if (shown != "-") {
      sphere = std::stoul(shown);
    }
    image.insert(image.end(), count, sphere);
  }
  return image;
}

}  // namespace raycheck::tools
