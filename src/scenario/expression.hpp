#pragma once

#include <map>
#include <memory>
#include <stdexcept>
#include <string>

namespace mu {
class Parser;
}

namespace mote {

using Constants = std::map<std::string, double>;

/// An expression that cannot be understood; `position` is the offending character, from 0, or -1.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(const std::string& message, int position)
      : std::runtime_error(message), position_(position) {}
  int position() const { return position_; }

 private:
  int position_;
};

/// Where an expression is evaluated.
struct Place {
  double x = 0, y = 0, z = 0, t = 0;
};

/// A formula in x, y, z, r (distance from the origin), t, pi and named constants, evaluated by
/// muParser; beside its functions there are clamp(value, lower, upper) and square_patch(x, y),
/// which is rotating_square_patch_pressure.
class Expression {
 public:
  /// Throws ExpressionError for unknown names and bad syntax.
  Expression(const std::string& text, const Constants& constants);
  ~Expression();
  Expression(Expression&&) noexcept;

  /// May be infinite or NaN where the formula is.
  double operator()(const Place& place) const;

  /// Whether the formula names x, y, z, r or t, and whether it names this one of them.
  bool depends_on_place() const;
  bool uses(const std::string& variable) const;

  /// Names that a constant must not have.
  static bool is_reserved(const std::string& name);

 private:
  struct Variables;
  std::unique_ptr<Variables> variables_;
  std::unique_ptr<mu::Parser> parser_;
};

}  // namespace mote
