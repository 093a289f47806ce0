#include "tools/view/page/page.h"

#include <fmt/core.h>
#include <zlib.h>

#include <stdexcept>

#include "tools/report/digest.h"
#include "tools/report/spelling.h"
#include "tools/view/page/assets.h"

namespace raycheck::tools {
namespace {

/// The size of zlib's window.
constexpr std::size_t kWindow = 1 << 15;

const Bytef* bytes_of(std::string_view text) { return reinterpret_cast<const Bytef*>(text.data()); }

/// The text compressed by zlib (RFC 1950) at its best level, as a continuation of `before`.
std::string deflated(std::string_view text, std::string_view before = {}) {
  z_stream stream{};
  if (deflateInit(&stream, Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib: out of memory");
  }
  if (before.size() > kWindow) before.remove_prefix(before.size() - kWindow);
  if (!before.empty()) {
    deflateSetDictionary(&stream, bytes_of(before), static_cast<uInt>(before.size()));
  }
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = const_cast<Bytef*>(bytes_of(text));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return bytes;
}

/// The source expression for a script or style in a content security policy (CSP level 3, 2.3.1).
std::string hash_source(std::string_view text) {
  return fmt::format("'sha256-{}'", base64(sha256(text)));
}

/// three.js, deflated. It is the same in every page, and deflating it is slow.
const std::string& three() {
  static const std::string text = base64(deflated(kThree));
  return text;
}

}  // namespace

std::size_t deflated_behind(std::string_view before, std::string_view text) {
  return deflated(text, before).size();
}

std::string page(const ViewDocument& document) {
  const std::string policy = fmt::format(
      "default-src 'none'; script-src {} {}; style-src {}; img-src data:; "
      "base-uri 'none'; form-action 'none'",
      hash_source(kPageScript), hash_source(kThree), hash_source(kPageStyle));
  return fmt::format(fmt::runtime(kPageTemplate), fmt::arg("csp", policy),
                     fmt::arg("title", escaped(document.title)), fmt::arg("style", kPageStyle),
                     fmt::arg("script", kPageScript),
                     fmt::arg("three", document.scenes.empty() ? "" : three()),
                     fmt::arg("document", base64(deflated(document_line(document)))));
}

}  // namespace raycheck::tools
