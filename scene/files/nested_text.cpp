#include "scene/files/nested_text.h"

#include <expat.h>
#include <yaml.h>

#include <algorithm>
#include <exception>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "scene/files/located_fields.h"
#include "scene/interruption.h"

namespace raycheck::scene {
namespace {

/// Rows, each with the names of what contains it.
class RowList {
 public:
  explicit RowList(std::string_view separators)
      : separators_(std::string(separators).append(" \t\v\f\r\n")) {}

  /// Adds a row with the words of a value, if it has some or begins a block.
  void add(std::string_view value, std::size_t line, bool begins) {
    const auto words = split_words(value, separators_);
    if (!begins && words.empty()) return;
    constexpr std::size_t kMost = 3;  // deeper names have no meaning
    NestedRow& row = rows_.emplace_back();
    for (std::size_t k = 0; k < std::min(names_.size(), kMost); ++k) row.words.push_back(names_[k]);
    row.words.insert(row.words.end(), words.begin(), words.end());
    row.line = line;
    row.begins = begins;
  }
  void enter(std::string_view name) {
    constexpr std::size_t kLongest = 60;
    names_.emplace_back(name.substr(0, kLongest));
  }
  void leave() { names_.pop_back(); }
  std::vector<NestedRow> take() { return std::move(rows_); }

 private:
  std::string separators_;
  std::vector<NestedRow> rows_;
  std::vector<std::string> names_;
};

class YamlReader {
 public:
  YamlReader(RowList& rows, std::string_view text, std::string_view file)
      : rows_(rows), located_(file) {
    if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
    yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                 text.size());
  }
  ~YamlReader() { yaml_parser_delete(&parser_); }
  YamlReader(const YamlReader&) = delete;
  YamlReader& operator=(const YamlReader&) = delete;

  /// The items of outermost sequences are blocks, and so are the parts of outermost mappings.
  void read() {
    while (true) {
      if (yaml_parser_load(&parser_, &document_) == 0) {
        fail(parser_.problem_mark, parser_.problem == nullptr ? "too large" : parser_.problem);
      }
      const std::unique_ptr<yaml_document_t, decltype(&yaml_document_delete)> owner(
          &document_, yaml_document_delete);
      const yaml_node_t* const root = yaml_document_get_root_node(&document_);
      if (root == nullptr) return;
      const Nodes parts = parts_of(*root);
      const bool is_mapping = root->type == YAML_MAPPING_NODE;
      for (std::size_t k = 0; k < parts.size(); ++k) {
        if (!is_mapping) {
          add(*parts[k], line_of(*parts[k]), true);
        } else if (is_flat(*parts[++k])) {
          rows_.add(text_of(*parts[k - 1]) + " " + text_of(*parts[k]), line_of(*parts[k - 1]),
                    true);
        } else {
          rows_.add(text_of(*parts[k - 1]), line_of(*parts[k - 1]), true);
          add(*parts[k], line_of(*parts[k]), false);
        }
      }
    }
  }

 private:
  using Nodes = std::vector<const yaml_node_t*>;

  [[noreturn]] void fail(const yaml_mark_t& at, const std::string& why) const {
    located_.fail(at.line + 1, "YAML", "is not valid: " + why);
  }
  static std::size_t line_of(const yaml_node_t& node) { return node.start_mark.line + 1; }

  /// The items of a sequence, or the keys and values of a mapping in turn.
  Nodes parts_of(const yaml_node_t& node) {
    Nodes parts;
    const auto add_part = [&](int index) {
      parts.push_back(yaml_document_get_node(&document_, index));
    };
    if (node.type == YAML_SEQUENCE_NODE) {
      const auto& items = node.data.sequence.items;
      std::for_each(items.start, items.top, add_part);
    } else if (node.type == YAML_MAPPING_NODE) {
      for (const auto* pair = node.data.mapping.pairs.start; pair < node.data.mapping.pairs.top;
           ++pair) {
        add_part(pair->key);
        add_part(pair->value);
      }
    }
    return parts;
  }

  bool is_flat(const yaml_node_t& node) {
    const Nodes parts = parts_of(node);
    return parts.empty() || (node.type != YAML_MAPPING_NODE &&
                             std::ranges::all_of(parts, [](const yaml_node_t* part) {
                               return part->type == YAML_SCALAR_NODE;
                             }));
  }
  /// A scalar's text, or that of the parts of a flat sequence; empty for others.
  std::string text_of(const yaml_node_t& node) {
    if (node.type == YAML_SCALAR_NODE) {
      return {reinterpret_cast<const char*>(node.data.scalar.value), node.data.scalar.length};
    }
    std::string all;
    if (!is_flat(node)) return all;
    for (const yaml_node_t* const part : parts_of(node)) all.append(text_of(*part)).append(" ");
    return all;
  }

  void add(const yaml_node_t& node, std::size_t line, bool begins, int depth = 0) {
    constexpr int kDeepest = 100;
    constexpr std::ptrdiff_t kMostRepeated = 1'000'000;
    poll();
    if (depth > kDeepest) fail(node.start_mark, "it is nested too deeply, or contains itself");
    if (++read_ > document_.nodes.top - document_.nodes.start + kMostRepeated) {
      fail(node.start_mark, "its aliases stand for too much");
    }
    if (is_flat(node)) return rows_.add(text_of(node), line, begins);
    const Nodes parts = parts_of(node);
    std::set<std::string> keys;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (node.type == YAML_SEQUENCE_NODE) {
        add(*parts[k], line_of(*parts[k]), std::exchange(begins, false), depth + 1);
      } else {
        const std::string key = text_of(*parts[k]);
        if (!keys.insert(key).second) fail(parts[k]->start_mark, "it has the key twice: " + key);
        rows_.enter(key);
        ++k;
        add(*parts[k], line_of(*parts[k - 1]), std::exchange(begins, false), depth + 1);
        rows_.leave();
      }
    }
  }

  RowList& rows_;
  LocatedFields located_;
  yaml_parser_t parser_ = {};
  yaml_document_t document_ = {};
  std::ptrdiff_t read_ = 0;
};

class XmlReader {
 public:
  XmlReader(RowList& rows, std::string_view file) : rows_(rows), located_(file) {
    if (parser_ == nullptr) throw std::bad_alloc();
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(parser_.get(), on_start, on_end);
    XML_SetExternalEntityRefHandler(parser_.get(), [](auto...) { return 0; });  // refuses files
  }

  void read(std::string_view text) {
    constexpr std::size_t kPart = std::size_t{1} << 16;
    while (true) {
      poll();
      const std::string_view part = text.substr(0, kPart);
      text.remove_prefix(part.size());
      const bool is_last = text.empty();
      const auto status = XML_Parse(parser_.get(), part.data(), static_cast<int>(part.size()),
                                    is_last ? XML_TRUE : XML_FALSE);
      if (failure_) std::rethrow_exception(failure_);
      if (status != XML_STATUS_OK) {
        located_.fail(
            line(), "XML",
            std::string("is not valid: ") + XML_ErrorString(XML_GetErrorCode(parser_.get())));
      }
      if (is_last) return;
    }
  }

 private:
  static void on_start(void* self, const char* tag, const char** attributes) {
    auto& reader = *static_cast<XmlReader*>(self);
    try {
      reader.start(tag, attributes);
    } catch (...) {  // expat is C
      reader.failure_ = std::current_exception();
      XML_StopParser(reader.parser_.get(), XML_FALSE);
    }
  }
  static void on_end(void* self, const char* /*tag*/) {
    auto& reader = *static_cast<XmlReader*>(self);
    if (--reader.depth_ > 1) reader.rows_.leave();
  }

  std::size_t line() const {
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
    return XML_GetCurrentLineNumber64(parser_.get());
#else
    return XML_GetCurrentLineNumber(parser_.get());
#endif
  }

  /// Elements below the root are blocks; an element with a name in one goes by it.
  void start(std::string_view tag, const char** attributes) {
    if (depth_++ == 0) return;
    std::map<std::string, std::string, std::less<>> given;
    for (; *attributes != nullptr; attributes += 2) given[attributes[0]] = attributes[1];
    const auto take = [&](const char* name, std::string_view otherwise) {
      const auto node = given.extract(name);
      return std::string(node.empty() ? otherwise : node.mapped()) + " ";
    };
    const bool is_block = depth_ == 2;
    const std::size_t line = this->line();
    rows_.enter(!is_block && given.contains("name") ? given.extract("name").mapped() : tag);
    rows_.add(take("type", "") + take("name", "") + take("value", ""), line, is_block);
    if (given.contains("x") || given.contains("y") || given.contains("z")) {
      const char* const otherwise = tag == "scale" ? "1" : "0";
      rows_.add(take("x", otherwise) + take("y", otherwise) + take("z", otherwise), line, false);
    }
    for (const auto& [attribute, value] : given) rows_.add(attribute + " " + value, line, false);
    if (is_block) rows_.leave();
  }

  RowList& rows_;
  LocatedFields located_;
  std::size_t depth_ = 0;
  std::exception_ptr failure_;
  std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_{XML_ParserCreate(nullptr),
                                                                       XML_ParserFree};
};

}  // namespace

std::vector<NestedRow> nested_rows(Nesting nesting, std::string_view text,
                                   std::string_view separators, std::string_view file) {
  RowList rows(separators);
  if (nesting == Nesting::kTags) XmlReader(rows, file).read(text);
  if (nesting == Nesting::kIndentation) YamlReader(rows, text, file).read();
  return rows.take();
}

std::vector<std::string_view> split_words(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; (at = text.find_first_not_of(separators, at)) != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

}  // namespace raycheck::scene
