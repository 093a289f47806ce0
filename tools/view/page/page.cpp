#include "tools/view/page/page.h"

#include <fmt/core.h>

#include "tools/report/digest.h"
#include "tools/report/packed.h"
#include "tools/report/spelling.h"
#include "tools/view/page/assets.h"

namespace raycheck::tools {
namespace {

/// The source expression for a script or style in a content security policy (CSP level 3, 2.3.1).
std::string hash_source(std::string_view text) {
  return fmt::format("'sha256-{}'", base64(sha256(text)));
}

/// Text compressed as well as zlib can, in base64.
std::string embedded(std::string_view text) { return base64(packed(text, Packing::kSmall)); }

/// three.js. It is the same in every page, and deflating it is slow.
const std::string& three() {
  static const std::string text = embedded(kThree);
  return text;
}

}  // namespace

std::string page(const ViewDocument& document) {
  const std::string policy = fmt::format(
      "default-src 'none'; script-src {} {}; style-src {}; img-src data:; "
      "base-uri 'none'; form-action 'none'",
      hash_source(kPageScript), hash_source(kThree), hash_source(kPageStyle));
  return fmt::format(fmt::runtime(kPageTemplate), fmt::arg("csp", policy),
                     fmt::arg("title", escaped(document.title)), fmt::arg("style", kPageStyle),
                     fmt::arg("script", kPageScript),
                     fmt::arg("three", document.scenes.empty() ? "" : three()),
                     fmt::arg("document", embedded(document_line(document))));
}

}  // namespace raycheck::tools
