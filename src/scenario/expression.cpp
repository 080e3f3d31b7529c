#include "mote/scenario/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <regex>

namespace mote {
namespace {

double clamp(double value, double lower, double upper) {
  return std::min(std::max(value, lower), upper);
}

constexpr std::array reserved_names{"x", "y", "z", "r", "t", "pi"};

std::string message_of(const mu::Parser::exception_type& error) {
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN: return fmt::format("unknown name '{}'", error.GetToken());
    case mu::ecUNEXPECTED_EOF: return "the expression ends too early";
    default: return error.GetMsg();
  }
}

/// muParser would let a formula change its variables.
void refuse_assignment(const std::string& text) {
  static const std::regex assignment("(^|[^<>=!])=([^=]|$)");
  std::smatch match;
  if (std::regex_search(text, match, assignment))
    throw ExpressionError("'=' assigns; a comparison is '=='", static_cast<int>(match.position()));
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
    for (const auto& [name, value] : constants) parser_->DefineConst(name, value);
    parser_->SetExpr(text);
    parser_->Eval();
    if (parser_->GetNumResults() != 1) throw ExpressionError("this is several expressions", 0);
  } catch (const mu::Parser::exception_type& error) {
    throw ExpressionError(message_of(error), static_cast<int>(error.GetPos()));
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;

double Expression::operator()(const Place& place) const {
  *variables_ = {place.x, place.y, place.z, std::hypot(place.x, place.y, place.z), place.t};
  return parser_->Eval();
}

bool Expression::depends_on_place() const { return !parser_->GetUsedVar().empty(); }

bool Expression::is_reserved(const std::string& name) {
  return std::ranges::find(reserved_names, name) != reserved_names.end();
}

}  // namespace mote
