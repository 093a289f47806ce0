#include "proofs/term.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <functional>
#include <map>

namespace raycheck::proofs {

std::string in_hexadecimal(double x) { return fmt::format("{:a}", x); }

Script::Script(Rounding rounding, std::optional<Mutation> mutation)
    : rounding_(rounding), mutation_(mutation) {}

void Script::define(const std::string& name, const std::string& term) {
  lines_.push_back({name, term, {}});
}

std::string Script::named(const std::string& term, const char* prefix,
                          std::optional<std::size_t> operation) {
  for (const Line& line : lines_) {
    if (line.term == term) return line.name;
  }
  lines_.push_back({prefix + std::to_string(lines_.size()), term, operation});
  return lines_.back().name;
}

std::string Script::rounded(char op, const std::string& x, const std::string& y,
                            const std::string& z) {
  const std::size_t operation = operations_++;
  if (mutation_ && mutation_->operation == operation) {
    op = op == '+' || op == 'f' ? '-' : op == 's' ? ' ' : '+';
  }
  const bool is_fused = !z.empty();
  has_fused_ = has_fused_ || is_fused;
  std::string term;
  if (rounding_ == Rounding::kRelative && is_fused) {
    const std::string minus = op == '-' ? "-" : "";
    term = "mul_add(" + x + ", " + y + ", " + minus + z + ")";
  } else if (op == 's' || op == ' ') {
    term = op == ' ' ? x : "rnd(sqrt(" + x + "))";
  } else if (rounding_ == Rounding::kToDouble || op == '/') {
    term = "rnd(" + x + " " + op + " " + y + ")";
  } else {
    const std::string name = op == '+' ? "add" : op == '-' ? "sub" : "mul";
    term = name + "(" + x + ", " + y + ")";
  }
  return named(term, "t", operation);
}

std::string Script::exact(const std::string& term) { return named(term, "M", {}); }

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_of_name(char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Calls visit(name, place) for every name (letters, digits and underscores, but not a number) in a
/// term, from the left.
template <class Visit>
void for_each_name(const std::string& term, const Visit& visit) {
  for (std::size_t at = 0; at < term.size();) {
    std::size_t end = at;
    while (end < term.size() && is_of_name(term[end])) ++end;
    if (end > at && !is_digit(term[at])) visit(term.substr(at, end - at), at);
    at = std::max(end, at + 1);
  }
}

}  // namespace

std::vector<Script::Line> Script::live() const {
  std::vector<Line> kept;
  const std::function<void(const std::string&, std::size_t)> keep = [&](const std::string& name,
                                                                        std::size_t) {
    const auto is_named = [&](const Line& line) { return line.name == name; };
    const auto line = std::find_if(lines_.begin(), lines_.end(), is_named);
    if (line == lines_.end() || std::any_of(kept.begin(), kept.end(), is_named)) return;
    for_each_name(line->term, keep);
    kept.push_back(*line);
  };
  for (const std::string& one : goals_) for_each_name(one, keep);
  for_each_name(hints_, keep);
  return kept;
}

std::vector<std::size_t> Script::operations() const {
  std::vector<std::size_t> all;
  for (const Line& line : live()) {
    if (line.operation) all.push_back(*line.operation);
  }
  return all;
}

std::string Script::text() const {
  std::string all =
      rounding_ == Rounding::kToDouble
          ? "@rnd = float<ieee_64, ne>;\n"
          : "@add = add_rel<53>; @sub = sub_rel<53>; @mul = mul_rel<53>; @mul_add = fma_rel<53>;\n"
            "@rnd = float<53, -20000, ne>;\n";
  // Renames in order of dependence, since compilers evaluate operands in different orders.
  std::map<std::string, std::string> renamed;
  const auto names = [&](const std::string& term) {
    std::string result;
    std::size_t from = 0;
    for_each_name(term, [&](const std::string& name, std::size_t at) {
      const bool is_made = (name[0] == 't' || name[0] == 'M') && name.size() > 1 &&
                           std::all_of(name.begin() + 1, name.end(), is_digit);
      const auto known = is_made ? renamed.find(name) : renamed.end();
      result += term.substr(from, at - from) + (known == renamed.end() ? name : known->second);
      from = at + name.size();
    });
    return result + term.substr(from);
  };
  std::vector<std::string> suppositions = hypotheses_;
  std::vector<std::string> in_order;
  for (const Line& line : live()) {
    const std::string term = names(line.term);
    if (line.name.size() > 1 && std::isdigit(static_cast<unsigned char>(line.name[1])) != 0) {
      renamed[line.name] = line.name.front() + std::to_string(renamed.size() + 1);
    }
    all += names(line.name) + " = " + term + ";\n";
    const auto of_line = [&](const std::string& one) {
      bool is_of = false;
      for_each_name(
          one, [&](const std::string& name, std::size_t) { is_of = is_of || name == line.name; });
      return is_of;
    };
    const auto rest = std::stable_partition(suppositions.begin(), suppositions.end(), of_line);
    in_order.insert(in_order.end(), suppositions.begin(), rest);
    suppositions.erase(suppositions.begin(), rest);
  }
  in_order.insert(in_order.end(), suppositions.begin(), suppositions.end());
  const auto joined = [&](const std::vector<std::string>& list) {
    std::string text;
    for (const std::string& one : list) text += (text.empty() ? "" : " /\\\n  ") + names(one);
    return text;
  };
  return all + "{ " + joined(in_order) + "\n->\n  " + joined(goals_) + " }\n" + names(hints_);
}

}  // namespace raycheck::proofs
