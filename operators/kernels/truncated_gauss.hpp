#pragma once

#include <cmath>
#include <numbers>

#include "mote/operators/kernels/kernel.hpp"
#include "mote/operators/kernels/space_integral.hpp"

namespace mote {

/// The window (1 - s)^2, s = (q/c)^2, of (90a), with its derivatives.
struct PolynomialWindow {
  static double value(double q, double c) { return std::pow(1 - q * q / (c * c), 2); }
  static double slope_over_q(double q, double c) { return -4 / (c * c) * (1 - q * q / (c * c)); }
  static double curvature(double q, double c) { return -4 / (c * c) * (1 - 3 * q * q / (c * c)); }
};

/// The window cos^2(pi q/(2 c)) of (90b), with its derivatives.
struct CosineWindow {
  static double value(double q, double c) {
    return std::pow(std::cos(std::numbers::pi * q / (2 * c)), 2);
  }
  static double slope_over_q(double q, double c) {
    const double k = std::numbers::pi / c;
    return q > 0 ? -0.5 * k * std::sin(k * q) / q : -0.5 * k * k;
  }
  static double curvature(double q, double c) {
    const double k = std::numbers::pi / c;
    return -0.5 * k * k * std::cos(k * q);
  }
};

/// A Gaussian of finite support and continuous slope (Isshiki 2014, (90)-(92); h here is the
/// paper's gamma, and the paper's h is c h):
///   h^D W = norm exp(-q^2/2) window(q),  q <= c = `cutoff`, norm from the unit integral (91).
/// At the rim the curvature jumps; the rim counts as inside (ERRATA).
template <int D, class Window>
class WindowedGauss {
 public:
  static constexpr double usual_length = 1;

  WindowedGauss() { normalise(); }

  double support() const { return cutoff_; }
  double value(double q) const {
    return inside(q, cutoff_) ? bell(q) * Window::value(q, cutoff_) : 0;
  }
  double slope_over_q(double q) const {
    if (!inside(q, cutoff_)) return 0;
    return bell(q) * (Window::slope_over_q(q, cutoff_) - Window::value(q, cutoff_));
  }
  double curvature(double q) const {
    if (!inside(q, cutoff_)) return 0;
    return bell(q) * (Window::curvature(q, cutoff_) - 2 * q * q * Window::slope_over_q(q, cutoff_) +
                      (q * q - 1) * Window::value(q, cutoff_));
  }

  void describe(Description& description) {
    description.number({"cutoff", "where the kernel ends, in smoothing lengths"}, cutoff_,
                       {0.1, 100});
    normalise();
  }

 private:
  double bell(double q) const { return norm_ * std::exp(-0.5 * q * q); }
  void normalise() {
    norm_ = 1;
    norm_ = 1 / space_integral<D>([this](double q) { return value(q); }, cutoff_);
  }

  double cutoff_ = 4;
  double norm_ = 1;
};

/// (90a).
template <int D>
struct TruncatedGauss : WindowedGauss<D, PolynomialWindow> {
  static constexpr std::string_view name = "truncated_gauss";
  static constexpr std::string_view summary = "Gaussian times (1 - (q/cutoff)^2)^2, (90a)";
};

/// (90b).
template <int D>
struct TruncatedGaussCosine : WindowedGauss<D, CosineWindow> {
  static constexpr std::string_view name = "truncated_gauss_cosine";
  static constexpr std::string_view summary = "Gaussian times cos^2(pi q/(2 cutoff)), (90b)";
};

}  // namespace mote
