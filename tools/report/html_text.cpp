#include "tools/report/html_text.h"

#include "scene/text.h"

namespace raycheck::tools {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : scene::visible(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace raycheck::tools
