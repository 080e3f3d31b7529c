#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/force_series.hpp"
#include "mote/integrators/integrator.hpp"

namespace mote {

/// Continuous evolution (ContEvol): over a step h the path is a polynomial x(t) that minimises
///   integral of |x'' - f(x)|^2 over [0, h],
/// for linear equations of small numbers of unknowns. A method of order n takes x, x', ..., up to
/// the derivative n at t = 0, and has n + 1 more coefficients to choose, up to t^(2n+1). The force
/// is expanded along the known part of the path, linearly in the unknown one: so it is exact up to
/// t^(2n+1) ("adequate", section 3.1 of the paper). The optimum is taken of that and of four powers
/// more, which the paper leaves out.
/// For systems that give their force as a series. Dense: for few bodies.
class ContEvol : public Integrator {
 public:
  std::string missing_in(System& system) const override;
  void advance_one_step(System& system, double time, double step) override;

  /// The polynomial, and its derivative.
  bool has_path() const override { return true; }
  void go_along_path(System& system, double part) override;

 protected:
  /// What is asked at t = h: nothing, or that the equation of motion holds there.
  enum class End { free, obeys };

  /// A method of this order of derivatives.
  ContEvol(int derivatives, End end) : derivatives_(derivatives), end_(end) {}

 private:
  /// Residuals of the equation of motion, matrix * unknowns + offset, for every power of t/h a
  /// block of rows.
  struct Residual {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd offset;
  };

  int degree() const { return 2 * derivatives_ + 1; }
  int last_power() const;
  void take_known_part(System& system, double step);
  Residual residual(ForceSeries& series, double step) const;
  Eigen::VectorXd best_unknowns(Residual residual) const;
  void move(System& system, double step);

  int derivatives_;
  End end_;
  double step_ = 0;
  std::vector<Eigen::VectorXd> path_;  ///< coefficients of the powers of t/h
};

/// First order: the path is cubic, equation (2.1.1) and section 3.1.
class ContEvol1 : public ContEvol {
 public:
  static constexpr std::string_view name = "contevol_1";
  static constexpr std::string_view summary =
      "order 4, cubic paths of least squared error of the equation, for few bodies";
  static constexpr int order = 4;
  ContEvol1() : ContEvol(1, End::free) {}
};

/// Second order: the path is of degree 5, and obeys the equation of motion at both ends of the
/// step, option 1 of section 2.3.
class ContEvol2Direct : public ContEvol {
 public:
  static constexpr std::string_view name = "contevol_2_direct";
  static constexpr std::string_view summary =
      "order 4, paths of degree 5 that obey the equation at both ends of a step";
  static constexpr int order = 4;
  ContEvol2Direct() : ContEvol(2, End::obeys) {}
};

/// Second order, with the equation of motion enforced at the start only, option 2 of section 2.3.
class ContEvol2Indirect : public ContEvol {
 public:
  static constexpr std::string_view name = "contevol_2_indirect";
  static constexpr std::string_view summary =
      "order 4, paths of degree 5 that obey the equation at the start of a step";
  static constexpr int order = 4;
  ContEvol2Indirect() : ContEvol(2, End::free) {}
};

}  // namespace mote
