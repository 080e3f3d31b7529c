#pragma once

#include <span>
#include <string>
#include <vector>

#include "mote/scenario/expression.hpp"
#include "mote/study/study_file.hpp"

namespace mote {

/// The fields of a study at any place, with their exact derivatives.
class ExactField {
 public:
  explicit ExactField(const StudyFile& study);

  /// Values at points of D = `dimension` coordinates each, one number a point.
  std::vector<double> density(std::span<const double> positions) const;
  std::vector<double> vorticity(std::span<const double> positions) const;
  std::vector<double> field(std::span<const double> positions) const;

  /// D numbers a point.
  std::vector<double> vector_field(std::span<const double> positions) const;

  /// The exact values of a quantity, `components(quantity).size()` numbers a point. The Hessian has
  /// all D x D components.
  std::vector<double> exact(const std::string& quantity, std::span<const double> positions) const;

  /// What a quantity's components are called behind its name: "", "_x" or "_xy".
  std::vector<std::string> components(const std::string& quantity) const;

 private:
  struct Formula {
    std::string key;   ///< of the study file, for errors
    std::string what;  ///< that it gives, for errors
    Expression expression;
  };
  static std::vector<Formula> formulas(const std::string& key, const std::string& what,
                                       const std::vector<std::string>& texts,
                                       const Constants& constants);
  /// The formulas at every point, one after the other. Throws InputError where one has no value.
  std::vector<double> values(const std::vector<Formula>& formulas,
                             std::span<const double> positions) const;

  std::size_t dimension_;
  std::vector<Formula> density_, vorticity_, field_, vector_field_, gradient_, hessian_, jacobian_;
};

}  // namespace mote
