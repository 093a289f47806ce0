#pragma once

// A number type that records its operations in Gappa's language. A formula that is a template over
// its number type is traced by calling it with this type. Gappa: Daumas and Melquiond,
// Certification of bounds on expressions involving rounded operators, 2010.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raycheck::proofs {

/// How an operation rounds. kRelative: with a relative error of at most u for every exponent, which
/// is true for doubles unless something under- or overflows. kToDouble: to a double.
enum class Rounding { kRelative, kToDouble };

std::string in_hexadecimal(double x);

/// The one rounding operation that a mutation replaces: a sum (fused or not) by a difference, a
/// square root by its argument, every other operation by a sum.
struct Mutation {
  std::size_t operation;
};

/// A script of Gappa, to which lines are added.
class Script {
 public:
  explicit Script(Rounding rounding, std::optional<Mutation> mutation = {});

  /// Names the result of an operation and returns the name. The operation is x op y; for 'f', x y +
  /// z; for 's', sqrt(x).
  std::string rounded(char op, const std::string& x, const std::string& y = "",
                      const std::string& z = "");
  std::string exact(const std::string& term);
  // Add definitions, hypotheses, goals, and hints on how Gappa may rewrite.
  void define(const std::string& name, const std::string& term);
  void suppose(const std::string& hypothesis) { hypotheses_.push_back(hypothesis); }
  void prove(const std::string& goal) { goals_.push_back(goal); }
  void rewrite(const std::string& hint) { hints_ += hint + ";\n"; }

  /// From now on x y + z is rounded once (the default) or twice.
  void fuse(bool is_fused) { is_fused_ = is_fused; }
  bool is_fused() const { return is_fused_; }
  bool has_fused() const { return has_fused_; }  ///< Whether an operation was fused.

  /// The operations that round and on which a goal depends.
  std::vector<std::size_t> operations() const;
  std::string text() const;

 private:
  struct Line {
    std::string name, term;
    std::optional<std::size_t> operation;
  };
  /// The name of a term: its name if it has one, otherwise a new name.
  std::string named(const std::string& term, const char* prefix,
                    std::optional<std::size_t> operation);
  /// The lines on which goals, hypotheses and hints depend.
  std::vector<Line> live() const;

  Rounding rounding_;
  std::optional<Mutation> mutation_;
  std::vector<Line> lines_;
  std::string hints_;
  std::vector<std::string> hypotheses_, goals_;
  std::size_t operations_ = 0;
  bool is_fused_ = true, has_fused_ = false;
};

/// A number of a script, rounded or exact.
template <bool kRounded>
class Term {
 public:
  Term(Script& script, std::string name) : script_(&script), name_(std::move(name)) {}
  explicit Term(double constant) : name_(in_hexadecimal(constant)) {}
  const std::string& name() const { return name_; }

  friend Term operator+(const Term& x, const Term& y) { return made('+', x, y); }
  friend Term operator-(const Term& x, const Term& y) { return made('-', x, y); }
  friend Term operator*(const Term& x, const Term& y) { return made('*', x, y); }
  friend Term operator/(const Term& x, const Term& y) { return made('/', x, y); }
  friend Term operator-(const Term& x) { return {*x.script_, "(-" + x.name_ + ")"}; }
  friend Term sqrt(const Term& x) {
    Script& script = *x.script_;
    return {script,
            kRounded ? script.rounded('s', x.name_) : script.exact("sqrt(" + x.name_ + ")")};
  }
  friend Term mul_add(const Term& x, const Term& y, const Term& z) {
    Script& script = script_of(x, y);
    if (!kRounded || !script.is_fused()) return x * y + z;
    return {script, script.rounded('f', x.name_, y.name_, z.name_)};
  }
  friend Term mul_sub(const Term& x, const Term& y, const Term& z) { return mul_add(x, y, -z); }
  friend Term sub_mul(const Term& x, const Term& y, const Term& z) { return mul_add(-x, y, z); }

 private:
  /// The script of an operand that has one; constants have none.
  static Script& script_of(const Term& x, const Term& y) {
    return x.script_ != nullptr ? *x.script_ : *y.script_;
  }
  static Term made(char op, const Term& x, const Term& y) {
    Script& script = script_of(x, y);
    return {script, kRounded ? script.rounded(op, x.name_, y.name_)
                             : script.exact(x.name_ + " " + op + " " + y.name_)};
  }

  Script* script_ = nullptr;
  std::string name_;
};

}  // namespace raycheck::proofs
