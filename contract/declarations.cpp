#include "contract/declarations.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>

namespace raycheck::contract {
namespace {

constexpr std::string_view kBlank = " \n\t\r";

/// Reads a declaration's value; "as-asked" for one that follows the scene.
template <class Value>
void read(Words& words, Value& value) {
  value = words.read<Value>();
}
template <class Value>
void read(Words& words, std::optional<Value>& value) {
  value = words.skip(kAsAsked) ? std::optional<Value>() : words.read<Value>();
}

template <class Value>
void append_declared(std::string& line, const std::optional<Value>& value) {
  if (value)
    append(line, *value);
  else
    line += kAsAsked;
}
template <class Value>
void append_declared(std::string& line, const Value& value) {
  append(line, value);
}

/// A statement for each declaration, sorted.
std::vector<std::string> all_statements(const Declarations& declared) {
  std::vector<std::string> all;
  for_each_declaration(declared, [&](std::string_view name, auto& value, auto /*meaning*/) {
    append_declared(all.emplace_back(std::string(name) + " "), value);
  });
  std::ranges::sort(all);
  return all;
}

template <class Conventions>
Conventions put_over(const DeclaredConventions& declared, Conventions conventions) {
  const auto put = [](const auto& ours, auto& theirs) {
    if (ours) theirs = *ours;
  };
  put(declared.rows, conventions.rows);
  put(declared.samples, conventions.samples);
  put(declared.origin, conventions.origin);
  put(declared.root, conventions.root);
  put(declared.tangent, conventions.tangent);
  put(declared.valid, conventions.valid);
  return conventions;
}

}  // namespace

scene::Conventions DeclaredConventions::over(scene::Conventions conventions) const {
  return put_over(*this, conventions);
}

DeclaredConventions DeclaredConventions::over(DeclaredConventions others) const {
  return put_over(*this, others);
}

void declare(Words& statement, Declarations& declared) {
  statement.skip("convention");  // as older programs write it
  const std::string_view which = statement.word();
  std::vector<std::string_view> names;
  bool is_known = false;
  const auto is_meant = [&](std::string_view name) {
    names.push_back(name);
    is_known = is_known || name == which;
    return name == which;
  };
  for_each_declaration(declared, [&](std::string_view name, auto& value, auto /*meaning*/) {
    if (is_meant(name)) read(statement, value);
  });
  scene::ValidRoots valid = declared.conventions.valid.value_or(scene::ValidRoots{});
  scene::for_each_field(valid, [&](std::string_view name, auto& value) {
    if (!is_meant(name)) return;
    read(statement, value);
    declared.conventions.valid = valid;
  });
  if (!is_known) {
    statement.fail("declares '" + shown(which) + "', not one of " + scene::joined(names));
  }
}

void declare_all(std::string_view contract, Declarations& declared) {
  std::set<std::string_view> names;
  while (!contract.empty()) {
    const std::size_t end = std::min(contract.find(';'), contract.size());
    std::string_view statement = contract.substr(0, end);
    contract.remove_prefix(std::min(end + 1, contract.size()));
    const std::size_t first = statement.find_first_not_of(kBlank);
    if (first == std::string_view::npos) continue;
    statement = statement.substr(first, statement.find_last_not_of(kBlank) + 1 - first);
    const std::string_view its_name = statement.substr(0, statement.find_first_of(kBlank));
    // "convention rows top-first" is the old form of "rows top-first".
    if (its_name != "convention" && !names.insert(its_name).second) {
      throw std::invalid_argument("the contract declares " + std::string(its_name) + " twice");
    }
    Words words(statement, "the contract");
    declare(words, declared);
    words.end();
  }
}

std::vector<std::string> statements(const Declarations& declared) {
  const std::vector<std::string> lines = all_statements(declared);
  const std::vector<std::string> usual = all_statements({});
  std::vector<std::string> different;
  std::ranges::set_difference(lines, usual, std::back_inserter(different));
  return different;
}

std::string roots_line(const scene::ValidRoots& valid) {
  std::string line = "roots ";
  append(line, valid);
  return line + '\n';
}

}  // namespace raycheck::contract
