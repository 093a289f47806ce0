#include "tools/grade/results/plain_text.h"

#include <regex>

#include "tools/external/sandbox/private_folder.h"

namespace raycheck::tools {

std::string plain_text(const std::string& said) {
  // How compilers quote.
  static const std::regex quotes("\xe2\x80[\x98\x99]");
  std::string text = std::regex_replace(without_private_folders(said), quotes, "'");
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < ' ' && c != '\n' && c != '\t') || byte > '~') c = '?';
  }
  return text;
}

}  // namespace raycheck::tools
