#include <fmt/core.h>

#include <cctype>
#include <cstdint>

#include "tools/grade/pages/wording.h"

namespace raycheck::tools {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --line: #8886; --good: #1a7f37; --bad: #c62828; --mild: #8a6d00; --link: #0550ae; }
@media (prefers-color-scheme: dark) { :root { --good: #57c878; --bad: #ff7b72; --mild: #d9b44a; --link: #79b8ff; } }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 0 auto; padding: 1rem; background: Canvas; color: CanvasText; } a { color: var(--link); }
h1 { font-size: 1.5rem; margin: 0.5rem 0; } h2 { font-size: 1.2rem; margin: 2rem 0 0.5rem; }
.total { font-size: 2rem; font-weight: 600; } .quiet { opacity: 0.75; }
details, .item { border: 1px solid var(--line); border-radius: 6px; margin: 0.5rem 0; padding: 0.5rem 0.75rem; }
summary { cursor: pointer; display: flex; gap: 0.75rem; align-items: baseline; flex-wrap: wrap; }
summary .name { flex: 1 1 12rem; font-size: 1rem; font-weight: 600; margin: 0; } .points { white-space: nowrap; }
.holds { border-left: 5px solid var(--good); } .fails { border-left: 5px solid var(--bad); }
.other { border-left: 5px solid var(--mild); }
.file { padding: 0.1rem 0.5rem; margin: 0.25rem 0; font-size: 0.9rem; } .file summary::before { content: "\25B8"; } .file[open] summary::before { content: "\25BE"; }
pre.command { margin: 0.1rem 0 0.4rem; padding: 0.3rem 0.5rem; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; padding: 0.5rem; border: 1px solid var(--line); border-radius: 4px; font-size: 0.85rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.1rem 0.75rem; }
dt { opacity: 0.75; } dd { margin: 0; overflow-wrap: anywhere; }
h3 { font-size: 1rem; margin: 1rem 0 0.25rem; } ol { padding-left: 1.5rem; margin: 0.25rem 0; } code { font-size: 0.9em; overflow-wrap: anywhere; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(8.5rem, 1fr)); gap: 0.75rem; margin: 0.75rem 0 0.25rem; }
figure { margin: 0; } figcaption { font-size: 0.9rem; }
figure img { display: block; height: auto; image-rendering: pixelated; border: 1px solid var(--line); }
.swatch { display: inline-block; width: 0.9em; height: 0.9em; border: 1px solid var(--line); vertical-align: -0.1em; margin-left: 0.5em; }
.wide { overflow-x: auto; } table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: 0.25rem 0.5rem; border-bottom: 1px solid var(--line); vertical-align: top; }
td.number, th.number { text-align: right; white-space: nowrap; }
.head td { border-bottom: 0; padding-bottom: 0; } .about td { padding-top: 0; font-size: 0.9rem; color: color-mix(in srgb, currentColor 75%, transparent); }
.bar { display: block; height: 0.9rem; background: var(--bad); border-radius: 2px; min-width: 1px; }
.score .bar { background: #4878a8; }
@media (max-width: 32rem) { body { padding: 0.5rem; } dl { grid-template-columns: 1fr; } dd { margin-bottom: 0.3rem; } }
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

std::string download(std::string_view file, std::string_view text) {
  std::string address = "data:text/plain;charset=utf-8,";
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      address += c;
    } else {
      address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return fmt::format("<a download=\"{0}\" href=\"{1}\">{0}</a>", escaped(file), address);
}

}  // namespace raycheck::tools
