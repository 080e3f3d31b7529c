#include "mote/scenario/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mote/exact/rotating_square_patch.hpp"

namespace mote {
namespace {

double clamp(double value, double lower, double upper) {
  return std::min(std::max(value, lower), upper);
}

constexpr std::array reserved_names{"x", "y", "z", "r", "t", "pi"};

/// The token up to its first sign that no name has: muParser gives the rest of the line.
std::string name_in(const std::string& token) {
  return token.substr(0, token.find_first_of(" \t\n+-*/^()<>=!&|?:,;"));
}

/// muParser's errors in our words; it says some of them in several places at once.
std::string message_of(const mu::Parser::exception_type& error) {
  const std::string token = error.GetToken();
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      return fmt::format("unknown name '{}'", name_in(token));
    case mu::ecEMPTY_EXPRESSION:
      return "the expression is empty";
    case mu::ecUNEXPECTED_EOF:
      return "the expression ends too early";
    case mu::ecMISSING_PARENS:
      return "a parenthesis is not closed";
    case mu::ecMISSING_ELSE_CLAUSE:
      return "a condition '?' has no else part ':'";
    case mu::ecMISPLACED_COLON:
      return "this ':' has no condition '?' before it";
    case mu::ecTOO_MANY_PARAMS:
      return fmt::format("{} has too many arguments", name_in(token));
    case mu::ecTOO_FEW_PARAMS:
      return fmt::format("{} has too few arguments", name_in(token));
    default:
      return token.empty() ? "it cannot be understood"
                           : fmt::format("'{}' cannot stand here", token);
  }
}

/// Where muParser saw the error; -1 where it says nothing, or the end of what it read.
int position_of(const mu::Parser::exception_type& error) {
  const bool has_place = error.GetCode() != mu::ecEMPTY_EXPRESSION;
  return has_place ? static_cast<int>(error.GetPos()) : -1;
}

/// muParser would let a formula change its variables.
void refuse_assignment(const std::string& text) {
  const std::string padded = " " + text + " ";
  for (std::size_t k = 1; k + 1 < padded.size(); ++k) {
    const bool comparison =
        std::string("<>=!").find(padded[k - 1]) != std::string::npos || padded[k + 1] == '=';
    if (padded[k] == '=' && !comparison)
      throw ExpressionError("'=' assigns; a comparison is '=='", static_cast<int>(k) - 1);
  }
}

}  // namespace

struct Expression::Variables {
  double x = 0, y = 0, z = 0, r = 0, t = 0;
};

Expression::Expression(const std::string& text, const Constants& constants)
    : variables_(std::make_unique<Variables>()), parser_(std::make_unique<mu::Parser>()) {
  refuse_assignment(text);
  try {
    parser_->DefineVar("x", &variables_->x);
    parser_->DefineVar("y", &variables_->y);
    parser_->DefineVar("z", &variables_->z);
    parser_->DefineVar("r", &variables_->r);
    parser_->DefineVar("t", &variables_->t);
    parser_->DefineConst("pi", std::numbers::pi);
    parser_->DefineFun("clamp", clamp);
    parser_->DefineFun("square_patch", rotating_square_patch_pressure);
    for (const auto& [name, value] : constants) parser_->DefineConst(name, value);
    parser_->SetExpr(text);
    parser_->Eval();
    if (parser_->GetNumResults() != 1) throw ExpressionError("this is several expressions", -1);
  } catch (const mu::Parser::exception_type& error) {
    throw ExpressionError(message_of(error), position_of(error));
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;

double Expression::operator()(const Place& place) const {
  *variables_ = {place.x, place.y, place.z, std::hypot(place.x, place.y, place.z), place.t};
  return parser_->Eval();
}

bool Expression::depends_on_place() const { return !parser_->GetUsedVar().empty(); }

bool Expression::uses(const std::string& variable) const {
  return parser_->GetUsedVar().contains(variable);
}

bool Expression::is_reserved(const std::string& name) {
  if (name == "clamp" || name == "square_patch" ||
      std::ranges::find(reserved_names, name) != reserved_names.end())
    return true;
  return mu::Parser().GetFunDef().contains(name);
}

}  // namespace mote
