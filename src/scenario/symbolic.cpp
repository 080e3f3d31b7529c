#include "mote/scenario/symbolic.hpp"

#include <fmt/format.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "mote/particles/random.hpp"

namespace mote {
namespace {

using GiNaC::ex;
using GiNaC::is_a;
using GiNaC::numeric;

ex magnitude_derivative(const ex& u, unsigned);

/// |u|. GiNaC's own abs is one of complex numbers, whose derivative holds conjugates.
DECLARE_FUNCTION_1P(magnitude)
REGISTER_FUNCTION(magnitude, derivative_func(magnitude_derivative))

/// |u| / u rather than u / |u|: its own derivative is exactly 0.
ex magnitude_derivative(const ex& u, unsigned) { return magnitude(u) / u; }

/// muParser's functions that have a derivative, in GiNaC's words.
const std::map<std::string, std::string> functions{
    {"abs", "magnitude"}, {"acos", "acos"},           {"acosh", "acosh"},       {"asin", "asin"},
    {"asinh", "asinh"},   {"atan", "atan"},           {"atan2", "atan2"},       {"atanh", "atanh"},
    {"cos", "cos"},       {"cosh", "cosh"},           {"exp", "exp"},           {"ln", "log"},
    {"log", "log"},       {"log10", "1/log(10)*log"}, {"log2", "1/log(2)*log"}, {"sin", "sin"},
    {"sinh", "sinh"},     {"sqrt", "sqrt"},           {"tan", "tan"},           {"tanh", "tanh"}};

/// A decimal number as an exact fraction in GiNaC's words, which would round it otherwise.
std::string exact_number(const std::string& literal) {
  const std::size_t e = literal.find_first_of("eE");
  std::string digits = literal.substr(0, e);
  long exponent = e == std::string::npos ? 0 : std::strtol(literal.c_str() + e + 1, nullptr, 10);
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return exponent == 0 ? digits : fmt::format("({}*10^({}))", digits, exponent);
}

/// The signs of which names consist; none begins with a digit.
constexpr const char* letters = "_0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

using Symbols = GiNaC::symtab;

/// A name as GiNaC's parser gets it: it reads I and Pi as numbers, and no name that begins with _.
std::string alias(const std::string& name) { return "c_" + name; }

/// The symbol of a name. What GiNaC does not know to be real, it takes as complex.
const ex& symbol_of(Symbols& symbols, const std::string& name) {
  const bool positive = name == "r" || name == "pi";
  const ex symbol = positive ? ex(GiNaC::possymbol(name)) : ex(GiNaC::realsymbol(name));
  return symbols.try_emplace(alias(name), symbol).first->second;
}

/// Rewrites a formula that muParser accepts so that GiNaC's parser reads the same: there, a sign
/// takes the whole product behind it (2/-x*3), a^b^c is an error and decimals are rounded.
class Rewriting {
 public:
  Rewriting(const std::string& formula, Symbols& symbols) : formula_(formula), symbols_(symbols) {
    read_list();
    if (next() != '\0') refuse("a condition", place_);
  }
  const std::string& text() const { return text_; }

 private:
  [[noreturn]] static void refuse(const std::string& part, std::size_t place) {
    throw ExpressionError(part + " has no symbolic derivative", static_cast<int>(place));
  }

  /// The next sign that is no space; '\0' at the end.
  char next() {
    place_ = std::min(formula_.find_first_not_of(" \t\n\v\f\r", place_), formula_.size());
    return place_ < formula_.size() ? formula_[place_] : '\0';
  }

  std::string take(std::size_t length) {
    const std::string taken = formula_.substr(place_, length);
    place_ += taken.size();
    return taken;
  }

  bool is_next(std::string_view signs) {
    const char sign = next();
    return sign != '\0' && signs.find(sign) != std::string_view::npos;
  }

  void read_enclosed() {
    text_ += "(";
    read_operand();
    text_ += ")";
  }

  /// Operands with operators between them, or the arguments of a function.
  void read_list() {
    read_enclosed();
    while (is_next("+-*/,")) {
      text_ += take(1);
      read_enclosed();
    }
  }

  /// A power with its sign: -a^b is -(a^b), a^b^c is a^(b^c).
  void read_operand() {
    if (++depth_ > 200) refuse("so deep a formula", place_);
    if (is_next("+-")) text_ += take(1);
    read_primary();
    if (is_next("^")) {
      text_ += take(1);
      read_enclosed();
    }
    --depth_;
  }

  void read_primary() {
    if (is_next("("))
      read_parentheses();
    else if (is_next("0123456789."))
      read_number();
    else if (is_next(letters))
      read_name();
    else
      refuse("a condition", place_);
  }

  void read_number() {
    const std::size_t begin = place_;
    const char* text = formula_.data();
    double value = 0;
    const auto [end, error] = std::from_chars(text + begin, text + formula_.size(), value);
    const auto length = static_cast<std::size_t>(end - text) - begin;
    if (error != std::errc{}) refuse(fmt::format("'{}'", take(length)), begin);
    text_ += exact_number(take(length));
  }

  void read_parentheses() {
    text_ += take(1);
    read_list();
    if (next() != ')') refuse("a condition", place_);
    text_ += take(1);
  }

  void read_name() {
    const std::size_t begin = place_;
    const std::string name = take(formula_.find_first_not_of(letters, begin) - begin);
    if (next() == '(') {
      if (!functions.contains(name)) refuse(fmt::format("'{}'", name), begin);
      text_ += "(" + functions.at(name);
      read_parentheses();
      text_ += ")";
    } else {
      symbol_of(symbols_, name);
      text_ += alias(name);
    }
  }

  const std::string& formula_;
  Symbols& symbols_;
  std::string text_;
  std::size_t place_ = 0;
  int depth_ = 0;
};

ex read(const std::string& formula, Symbols& symbols) {
  const std::string text = Rewriting(formula, symbols).text();
  return GiNaC::parser(symbols, true)(text);
}

/// Puts the values of constants into exponents: the derivative of x^n at x = 0 is a number only if
/// n is known.
struct ExponentValues : GiNaC::map_function {
  GiNaC::exmap values;

  ExponentValues(const Constants& constants, Symbols& symbols) {
    for (const auto& [name, value] : constants)
      if (std::isfinite(value))
        values[symbol_of(symbols, name)] = read(fmt::format("{}", value), symbols);
  }

  ex operator()(const ex& value) override {
    const ex inner = value.map(*this);
    return is_a<GiNaC::power>(inner) ? pow(inner.op(0), inner.op(1).subs(values)) : inner;
  }
};

// GiNaC orders terms by addresses in memory, which change from run to run, and prints what muParser
// does not read. So an expression is written here, in the order of the texts of its terms.

struct Term {
  std::string text;
  bool negative;
};
using Terms = std::vector<Term>;

Terms terms_of(const ex& value);

std::string text_of(const Terms& terms) {
  std::string text;
  for (const Term& term : terms) {
    const char* sign = text.empty() ? (term.negative ? "-" : "") : (term.negative ? " - " : " + ");
    text += sign + term.text;
  }
  return text;
}

std::string text_of(const ex& value);

/// A function by its name in muParser. Not every muParser means the same by `log`.
std::string function_text(const GiNaC::function& call) {
  std::string name = call.get_name();
  if (name == "log") name = "ln";
  if (name == "magnitude") name = "abs";
  if (is_a<GiNaC::fderivative>(call) || !functions.contains(name))
    throw ExpressionError(fmt::format("'{}' has no symbolic derivative", name), -1);
  std::vector<std::string> arguments;
  for (std::size_t k = 0; k < call.nops(); ++k) arguments.push_back(text_of(call.op(k)));
  return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

std::string text_of(const ex& value) {
  if (is_a<GiNaC::symbol>(value)) return GiNaC::ex_to<GiNaC::symbol>(value).get_name();
  if (is_a<GiNaC::function>(value)) return function_text(GiNaC::ex_to<GiNaC::function>(value));
  return value.is_equal(GiNaC::Pi) ? "pi" : text_of(terms_of(value));
}

/// The text of an expression in a place where only one without operators needs no parentheses.
std::string enclosed(const std::string& text, const ex& value) {
  const bool plain = is_a<GiNaC::symbol>(value) || is_a<GiNaC::function>(value) ||
                     is_a<GiNaC::constant>(value) || value.info(GiNaC::info_flags::nonnegint);
  return plain ? text : "(" + text + ")";
}

/// A product as a fraction.
struct Product {
  numeric coefficient = 1;
  std::vector<std::string> over, under;
};

/// The base of a power; a sum with a sign such that its first term is positive: GiNaC chooses (x -
/// y)^2 or (y - x)^2 by the order of its terms.
std::string base_text(const ex& base, const ex& exponent, numeric& coefficient) {
  if (!is_a<GiNaC::add>(base)) return text_of(base);
  Terms terms = terms_of(base);
  if (exponent.info(GiNaC::info_flags::integer) && terms.front().negative) {
    for (Term& term : terms) term.negative = !term.negative;
    if (exponent.info(GiNaC::info_flags::odd)) coefficient = -coefficient;
  }
  return text_of(terms);
}

bool has_minus(const ex& exponent) {
  const ex number = is_a<GiNaC::mul>(exponent) ? exponent.op(exponent.nops() - 1) : exponent;
  return number.info(GiNaC::info_flags::negative);
}

void multiply(Product& product, const ex& factor) {
  if (is_a<numeric>(factor)) {
    product.coefficient *= GiNaC::ex_to<numeric>(factor);
    return;
  }
  const bool is_power = is_a<GiNaC::power>(factor);
  const ex base = is_power ? factor.op(0) : factor, exponent = is_power ? factor.op(1) : ex(1);
  std::string text = base_text(base, exponent, product.coefficient);
  const bool below = has_minus(exponent);
  const ex size = below ? -exponent : exponent;
  const bool is_root = size.is_equal(numeric(1, 2));
  text = is_root ? "sqrt(" + text + ")" : enclosed(text, base);
  if (!is_root && !size.is_equal(1)) text += "^" + enclosed(text_of(size), size);
  (below ? product.under : product.over).push_back(text);
}

/// Writes a positive coefficient: a fraction of small numbers as such, any other with all digits.
void write_coefficient(Product& product) {
  const numeric over = product.coefficient.numer(), under = product.coefficient.denom();
  const bool small = over < 1000000 && under < 1000000;
  const double value = small ? over.to_double() : product.coefficient.to_double();
  if (!std::isfinite(value)) throw ExpressionError("a number in the derivative is too large", -1);
  if (value != 1) product.over.insert(product.over.begin(), fmt::format("{}", value));
  if (small && under > 1)
    product.under.insert(product.under.begin(), fmt::format("{}", under.to_long()));
}

Term term_of(const ex& value) {
  Product product;
  if (is_a<GiNaC::mul>(value))
    for (std::size_t k = 0; k < value.nops(); ++k) multiply(product, value.op(k));
  else
    multiply(product, value);
  std::ranges::sort(product.over);
  std::ranges::sort(product.under);
  if (!product.coefficient.is_rational())
    throw ExpressionError("the formula is not real, and has no symbolic derivative", -1);
  const bool negative = product.coefficient.is_negative();
  if (negative) product.coefficient = -product.coefficient;
  write_coefficient(product);
  std::string text = fmt::format("{}", fmt::join(product.over, "*"));
  if (text.empty()) text = "1";
  if (product.under.size() == 1) text += "/" + product.under.front();
  if (product.under.size() > 1) text += fmt::format("/({})", fmt::join(product.under, "*"));
  return {text, negative};
}

Terms terms_of(const ex& value) {
  Terms terms;
  if (is_a<GiNaC::add>(value))
    for (std::size_t k = 0; k < value.nops(); ++k) terms.push_back(term_of(value.op(k)));
  else
    terms.push_back(term_of(value));
  std::ranges::sort(terms, {}, &Term::text);
  return terms;
}

/// df/dx where f depends on x also by r, and dr/dx = x/r. Every term of df/dr is divided on its
/// own: where it holds r, there is no 0/0 at the origin.
ex total_derivative(const ex& f, const ex& x, const ex& r) {
  const ex slope = f.diff(GiNaC::ex_to<GiNaC::symbol>(r));
  ex sum = f.diff(GiNaC::ex_to<GiNaC::symbol>(x));
  if (!is_a<GiNaC::add>(slope)) return sum + slope * x / r;
  for (std::size_t k = 0; k < slope.nops(); ++k) sum += slope.op(k) * x / r;
  return sum;
}

/// A fixed random place in boxes from 0.001 to 10^4 wide; the shift is relative.
Place probe(int k, double shift) {
  const auto coordinate = [&](int d) {
    const double u = uniform_random(1, static_cast<std::uint64_t>(4 * k + d));
    return std::pow(10, k % 8 - 3) * (2 * u - 1) * (1 + (d + 1) * shift);
  };
  return {coordinate(0), coordinate(1), coordinate(2), coordinate(3)};
}

constexpr double shake = 1e-14;

/// Whole numbers stay: as an exponent, 2 is defined where 2.1 is not.
Constants shaken(Constants constants) {
  double factor = 1;
  for (auto& [name, value] : constants)
    if (value != std::round(value)) value *= factor += 7 * shake;
  return constants;
}

/// Whether two values are the same but for some rounding.
bool agree(double value, double other) {
  return std::abs(value - other) <=
         1e-10 * std::max(std::abs(value), std::abs(other)) + std::numeric_limits<double>::min();
}

/// Two libraries read the formula; this compares what they understood, at places where a shake
/// shows that rounding does not matter.
void require_same_reading(const std::string& formula, const std::string& reading,
                          const Constants& constants) {
  const Expression first(formula, constants), second(reading, constants);
  const Expression moved(formula, shaken(constants));
  int compared = 0;
  for (int k = 0; k < 80; ++k) {
    const double value = first(probe(k, 0)), other = second(probe(k, 0));
    if (!std::isfinite(value + other) || !agree(value, moved(probe(k, shake)))) continue;
    ++compared;
    if (!agree(value, other))
      throw ExpressionError("the formula is read in two ways; its derivative must be given", -1);
  }
  if (compared == 0)
    throw ExpressionError("the formula is definite nowhere; its derivative must be given", -1);
}

}  // namespace

std::string derivative_of(const std::string& formula, char variable, const Constants& constants) {
  if (variable < 'x' || variable > 'z') throw std::invalid_argument("derivative by x, y or z only");
  Expression(formula, constants);  // muParser's own words for what it refuses
  try {
    Symbols symbols;
    const ex f = ExponentValues(constants, symbols)(read(formula, symbols));
    require_same_reading(formula, text_of(f), constants);
    return text_of(
        total_derivative(f, symbol_of(symbols, std::string(1, variable)), symbol_of(symbols, "r")));
  } catch (const ExpressionError&) {
    throw;
  } catch (const std::exception& error) {
    throw ExpressionError(fmt::format("it has no symbolic derivative: {}", error.what()), -1);
  }
}

}  // namespace mote
