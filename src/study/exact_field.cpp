#include "mote/study/exact_field.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// The component xx, xy, ... at row c and column d of a symmetric matrix kept by its upper half.
std::size_t upper_half(std::size_t c, std::size_t d, std::size_t dimension) {
  if (c > d) std::swap(c, d);
  return c * dimension - c * (c + 1) / 2 + d;
}

}  // namespace

ExactField::ExactField(const StudyFile& study)
    : dimension_(static_cast<std::size_t>(study.dimension)) {
  const Constants constants = study.constants_by_name();
  density_ = formulas("density", "'density'", {study.density}, constants);
  vorticity_ = formulas("vorticity", "'vorticity'", {study.vorticity}, constants);
  field_ = formulas("field", "'field'", {study.field}, constants);
  vector_field_ = formulas("vector_field", "'vector_field'", study.vector_field, constants);
  const auto& given = study.derivatives;
  gradient_ = formulas("field", "the gradient of 'field'", given.gradient, constants);
  hessian_ = formulas("field", "the Hessian of 'field'", given.hessian, constants);
  jacobian_ =
      formulas("vector_field", "the derivative of 'vector_field'", given.jacobian, constants);
}

std::vector<ExactField::Formula> ExactField::formulas(const std::string& key,
                                                      const std::string& what,
                                                      const std::vector<std::string>& texts,
                                                      const Constants& constants) {
  std::vector<Formula> formulas;
  for (const std::string& text : texts)
    formulas.push_back({key, what, Expression(text, constants)});
  return formulas;
}

std::vector<double> ExactField::values(const std::vector<Formula>& formulas,
                                       std::span<const double> positions) const {
  std::vector<double> values;
  values.reserve(positions.size() / dimension_ * formulas.size());
  for (std::size_t k = 0; k < positions.size(); k += dimension_) {
    const Place place{.x = positions[k],
                      .y = dimension_ > 1 ? positions[k + 1] : 0,
                      .z = dimension_ > 2 ? positions[k + 2] : 0};
    for (const auto& [key, what, expression] : formulas) {
      values.push_back(expression(place));
      if (!std::isfinite(values.back()))
        throw InputError(key, fmt::format("{} has no finite value at ({:.6g})", what,
                                          fmt::join(positions.subspan(k, dimension_), ", ")));
    }
  }
  return values;
}

std::vector<double> ExactField::density(std::span<const double> positions) const {
  std::vector<double> density = values(density_, positions);
  for (std::size_t i = 0; i < density.size(); ++i)
    if (density[i] <= 0)
      throw InputError(
          "density",
          fmt::format("the density must be positive, and is {:.6g} at ({:.6g})", density[i],
                      fmt::join(positions.subspan(i * dimension_, dimension_), ", ")));
  return density;
}
std::vector<double> ExactField::vorticity(std::span<const double> positions) const {
  return values(vorticity_, positions);
}
std::vector<double> ExactField::field(std::span<const double> positions) const {
  return values(field_, positions);
}
std::vector<double> ExactField::vector_field(std::span<const double> positions) const {
  return values(vector_field_, positions);
}

std::vector<double> ExactField::exact(const std::string& quantity,
                                      std::span<const double> positions) const {
  const std::size_t d = dimension_;
  const bool of_vector = quantity == "divergence" || quantity == "curl";
  if (quantity == "gradient") return values(gradient_, positions);
  const std::vector<double> all = values(of_vector ? jacobian_ : hessian_, positions);
  const std::size_t parts = of_vector ? d * d : d * (d + 1) / 2;
  std::vector<double> result;
  for (std::size_t k = 0; k < all.size(); k += parts) {
    const auto hessian = [&](std::size_t c, std::size_t e) { return all[k + upper_half(c, e, d)]; };
    const auto jacobian = [&](std::size_t c, std::size_t e) { return all[k + c * d + e]; };
    double trace = 0;
    for (std::size_t c = 0; c < d; ++c) trace += of_vector ? jacobian(c, c) : hessian(c, c);
    if (quantity == "laplacian" || quantity == "divergence") result.push_back(trace);
    if (quantity == "hessian")
      for (std::size_t c = 0; c < d; ++c)
        for (std::size_t e = 0; e < d; ++e) result.push_back(hessian(c, e));
    if (quantity == "curl")
      for (std::size_t axis = d == 2 ? 2 : 0; axis < 3; ++axis) {
        const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
        result.push_back(jacobian(last, next) - jacobian(next, last));
      }
  }
  return result;
}

std::vector<std::string> ExactField::components(const std::string& quantity) const {
  if (quantity == "laplacian" || quantity == "divergence") return {""};
  if (quantity == "curl" && dimension_ == 2) return {""};
  std::vector<std::string> names;
  for (std::size_t c = 0; c < dimension_; ++c)
    if (quantity == "hessian")
      for (std::size_t d = 0; d < dimension_; ++d)
        names.push_back(fmt::format("_{}{}", axis_names[c], axis_names[d]));
    else
      names.push_back(fmt::format("_{}", axis_names[c]));
  return names;
}

}  // namespace mote
