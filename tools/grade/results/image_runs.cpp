#include "tools/grade/results/image_runs.h"

#include <optional>
#include <sstream>
#include <stdexcept>

namespace raycheck::tools {

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

properties::ImageAnswer image_of(const std::string& runs, std::size_t pixels) {
  std::istringstream words(runs);
  properties::ImageAnswer image;
  std::size_t count = 0;
  char x = 0;
  for (std::string shown; words >> count >> x >> shown;) {
    if (count > pixels - image.size()) throw std::invalid_argument("too many pixels");
    std::optional<std::size_t> sphere;
    if (shown == "?") {
      sphere = properties::kSomeSphere;
    } else if (shown != "-") {
      sphere = std::stoul(shown);
    }
    image.insert(image.end(), count, sphere);
  }
  if (image.size() != pixels) throw std::invalid_argument("pixels are missing");
  return image;
}

}  // namespace raycheck::tools
