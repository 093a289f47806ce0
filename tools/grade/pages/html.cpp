#include <fmt/core.h>

#include <array>
#include <cctype>
#include <cstdint>
#include <set>
#include <vector>

#include "scene/text.h"
#include "tools/grade/pages/views.h"
#include "tools/report/picture_file.h"
#include "tools/report/spelling.h"
#include "tools/report/words.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --line: #8886; --good: #1a7f37; --bad: #c62828; --mild: #8a6d00;
  --link: #0550ae; }
@media (prefers-color-scheme: dark) {
  :root { --good: #57c878; --bad: #ff7b72; --mild: #d9b44a; --link: #79b8ff; } }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 0 auto; padding: 1rem;
  background: Canvas; color: CanvasText; }
a { color: var(--link); }
h1 { font-size: 1.5rem; margin: 0.5rem 0; } h2 { font-size: 1.2rem; margin: 2rem 0 0.5rem; }
.total { font-size: 2rem; font-weight: 600; } .quiet { opacity: 0.75; }
details, .item { border: 1px solid var(--line); border-radius: 6px; margin: 0.5rem 0;
  padding: 0.5rem 0.75rem; }
summary { cursor: pointer; display: flex; gap: 0.75rem; align-items: baseline; flex-wrap: wrap; }
summary .name { flex: 1 1 12rem; font-size: 1rem; font-weight: 600; margin: 0; }
.points { white-space: nowrap; }
.holds { border-left: 5px solid var(--good); } .fails { border-left: 5px solid var(--bad); }
.other { border-left: 5px solid var(--mild); }
.file { padding: 0.1rem 0.5rem; margin: 0.25rem 0; font-size: 0.9rem; }
.file summary::before { content: "\25B8"; } .file[open] summary::before { content: "\25BE"; }
pre.command { margin: 0.1rem 0 0.4rem; padding: 0.3rem 0.5rem; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; padding: 0.5rem; border: 1px solid var(--line);
  border-radius: 4px; font-size: 0.85rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.1rem 0.75rem; }
dt { opacity: 0.75; } dd { margin: 0; overflow-wrap: anywhere; }
h3 { font-size: 1rem; margin: 1rem 0 0.25rem; } ol { padding-left: 1.5rem; margin: 0.25rem 0; }
code { font-size: 0.9em; overflow-wrap: anywhere; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(8.5rem, 1fr));
  gap: 0.75rem; margin: 0.75rem 0 0.25rem; }
figure { margin: 0; } figcaption { font-size: 0.9rem; }
figure img { display: block; height: auto; image-rendering: pixelated;
  border: 1px solid var(--line); }
.swatch { display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid var(--line);
  vertical-align: -0.1em; margin-left: 0.5em; }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: 0.25rem 0.5rem; border-bottom: 1px solid var(--line);
  vertical-align: top; }
td.number, th.number { text-align: right; white-space: nowrap; }
.head td { border-bottom: 0; padding-bottom: 0; }
.about td { padding-top: 0; font-size: 0.9rem;
  color: color-mix(in srgb, currentColor 75%, transparent); }
.bar { display: block; height: 0.9rem; background: var(--bad); border-radius: 2px; min-width: 1px; }
.score .bar { background: #4878a8; }
@media (max-width: 32rem) {
  body { padding: 0.5rem; } dl { grid-template-columns: 1fr; } dd { margin-bottom: 0.3rem; } }
)";

}  // namespace

std::string page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</"
      "html>\n",
      escaped(title), kStyle, body);
}

std::string percent_encoded(std::string_view text, std::string_view plain) {
  std::string encoded;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = std::isalnum(byte) != 0 || plain.find(c) != plain.npos;
    encoded += is_plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return encoded;
}

std::string download(std::string_view file, std::string_view text) {
  return fmt::format("<a download=\"{0}\" href=\"data:text/plain;charset=utf-8,{1}\">{0}</a>",
                     escaped(file), percent_encoded(text));
}

namespace {

using properties::ImageAnswer;
using properties::kSomeSphere;
using properties::kUnclear;
using Sphere = ImageAnswer::value_type;

/// Okabe and Ito's colours, which colour-blind readers can distinguish; black is the background.
constexpr std::array<Colour, 7> kColours = {{{230, 159, 0},
                                             {86, 180, 233},
                                             {0, 158, 115},
                                             {240, 228, 66},
                                             {0, 114, 178},
                                             {213, 94, 0},
                                             {204, 121, 167}}};
constexpr Colour kSomeColour = {255, 255, 255};
constexpr Colour kQuiet = {60, 60, 60};

/// The largest height of a picture on a page, in rem.
constexpr double kTallest = 20;

/// The width and height of a mark, which represents one pixel in the picture of differences. Marks
/// also differ in shape.
constexpr int kMark = 7;
struct Mark {
  Colour colour;
  std::array<const char*, kMark> shape;
  const char* sign;
  const char* meaning;
};
constexpr Mark kMarks[] = {
    {{230, 159, 0},
     {".......", ".#####.", ".#...#.", ".#...#.", ".#...#.", ".#####.", "......."},
     "&#9633;",
     "a sphere is missing"},
    {{86, 180, 233},
     {".......", ".#...#.", "..#.#..", "...#...", "..#.#..", ".#...#.", "......."},
     "&#10005;",
     "a sphere is shown instead of the background"},
    {{240, 228, 66},
     {".......", ".......", ".#####.", ".......", ".#####.", ".......", "......."},
     "=",
     "the wrong sphere is shown"}};

/// The mark of a pixel; null if the pixel is right.
const Mark* mark_of(const Sphere& got, const Sphere& exact) {
  if (got == exact || got == kUnclear || (got == kSomeSphere && exact)) return nullptr;
  return &kMarks[!got ? 0 : !exact ? 1 : 2];
}

/// A picture by the case's camera, from the top line on.
struct Canvas {
  explicit Canvas(const FailingCase& failing)
      : width(failing.the_case.scene.camera->width),
        height(failing.the_case.scene.camera->height),
        bottom_first(failing.the_case.scene.conventions.rows == scene::Rows::kBottomFirst) {}

  /// The pixel in column x of line y.
  std::size_t at(std::int64_t x, std::int64_t y) const {
    return static_cast<std::size_t>((bottom_first ? height - 1 - y : y) * width + x);
  }

  std::int64_t width, height;
  bool bottom_first;
};

Colour colour_of(const Sphere& sphere) {
  if (!sphere) return {};
  if (sphere == kUnclear) return kQuiet;
  return *sphere == kSomeSphere ? kSomeColour : kColours[*sphere % kColours.size()];
}

std::string image_html(std::int64_t width, std::int64_t height, const std::vector<Colour>& pixels,
                       const std::string& alt, const std::string& caption) {
  return fmt::format(
      "<figure><img width=\"{}\" height=\"{}\" style=\"width: min(100%, {:.2f}rem)\" alt=\"{}\" "
      "src=\"{}\"><figcaption>{}</figcaption></figure>\n",
      width, height, kTallest * static_cast<double>(width) / static_cast<double>(height),
      escaped(alt), data_address("image/png", png_bytes(width, height, pixels)), caption);
}

/// "sphere 0", "a sphere"
std::string name_of(std::size_t sphere) {
  return sphere == kSomeSphere ? "a sphere" : fmt::format("sphere {}", sphere);
}

std::set<std::size_t> spheres_of(const ImageAnswer& image) {
  std::set<std::size_t> shown;
  for (const Sphere& sphere : image) {
    if (sphere && sphere != kUnclear) shown.insert(*sphere);
  }
  return shown;
}

/// The pixels of a picture whose every pixel is a square of `side` pixels.
template <class ColourAt>
std::vector<Colour> drawn(const Canvas& canvas, int side, const ColourAt& colour_at) {
  std::vector<Colour> pixels;
  for (std::int64_t y = 0; y < canvas.height * side; ++y) {
    for (std::int64_t x = 0; x < canvas.width * side; ++x) {
      pixels.push_back(colour_at(canvas.at(x / side, y / side), x % side, y % side));
    }
  }
  return pixels;
}

std::string drawn_html(const Canvas& canvas, const ImageAnswer& image, std::string_view whose) {
  const auto pixels =
      drawn(canvas, 1, [&](std::size_t at, auto...) { return colour_of(image[at]); });
  const std::string shown = scene::joined(spheres_of(image), ", ", name_of);
  return image_html(canvas.width, canvas.height, pixels,
                    fmt::format("{}, {} by {} pixels: {}", whose, canvas.width, canvas.height,
                                shown.empty() ? "no sphere, black" : shown),
                    std::string(whose) + (shown.empty() ? ": no sphere" : ""));
}

std::string difference_html(const FailingCase& failing, std::string_view whose) {
  const Canvas canvas(failing);
  const ComparedPictures& pictures = *failing.pictures;
  std::set<const Mark*> used;
  const auto pixels = drawn(canvas, kMark, [&](std::size_t at, std::int64_t x, std::int64_t y) {
    const Sphere& exact = (*pictures.exact)[at];
    const Mark* const mark = mark_of(pictures.got[at], exact);
    if (mark != nullptr) used.insert(mark);
    const bool is_marked = mark != nullptr && mark->shape[static_cast<std::size_t>(y)][x] == '#';
    return is_marked ? mark->colour : exact ? kQuiet : Colour{};
  });
  std::string caption = "difference";
  for (const Mark& mark : kMarks) {
    if (used.contains(&mark)) caption += fmt::format("<br>{} {}", mark.sign, mark.meaning);
  }
  return image_html(canvas.width * kMark, canvas.height * kMark, pixels,
                    difference_text(failing, whose), caption);
}

/// The legend of the spheres' colours; empty if the pictures do not identify spheres.
std::string legend_html(const ComparedPictures& pictures) {
  std::set<std::size_t> shown = spheres_of(pictures.got);
  if (pictures.exact) shown.merge(spheres_of(*pictures.exact));
  if (shown.empty() || *shown.begin() == kSomeSphere) return "";
  std::string html;
  for (const std::size_t sphere : shown) {
    const auto [red, green, blue] = colour_of(sphere);
    html +=
        fmt::format("<span class=\"swatch\" style=\"background: #{:02x}{:02x}{:02x}\"></span> {} ",
                    red, green, blue, name_of(sphere));
  }
  return "<p>" + html + "</p>\n";
}

}  // namespace

std::string difference_text(const FailingCase& failing, std::string_view whose) {
  if (!failing.pictures || !failing.pictures->exact) return "";
  const ComparedPictures& pictures = *failing.pictures;
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < pictures.got.size(); ++k) {
    wrong += mark_of(pictures.got[k], (*pictures.exact)[k]) != nullptr ? 1 : 0;
  }
  const std::string text = fmt::format(
      "{} of {} differ{}", wrong, count_text(pictures.got.size(), "pixel"), wrong == 1 ? "s" : "");
  const bool shows_none = wrong > 0 && spheres_of(pictures.got).empty();
  return shows_none ? fmt::format("{}: {} shows no sphere", text, whose) : text;
}

std::string pictures_html(const FailingCase& failing, std::string_view whose) {
  if (!failing.pictures) return "";
  const Canvas canvas(failing);
  const ComparedPictures& pictures = *failing.pictures;
  std::string html = "<div class=\"pictures\">\n" + drawn_html(canvas, pictures.got, whose);
  if (pictures.exact) {
    html += drawn_html(canvas, *pictures.exact, "expected") + difference_html(failing, whose);
  }
  html += "</div>\n";
  const std::string difference = difference_text(failing, whose);
  if (!difference.empty()) html += "<p>" + escaped(difference) + "</p>\n";
  return html + legend_html(pictures);
}

}  // namespace raycheck::tools
