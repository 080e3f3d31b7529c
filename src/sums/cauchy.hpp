#pragma once

#include <complex>
#include <memory>
#include <span>

#include "mote/sums/sum_settings.hpp"

namespace mote {

using Complex = std::complex<double>;

/// Trummer's problem, a Cauchy matrix times a vector: c_i = sum_j v_j/(s_i - t_j)
/// (Tabanjeh 2014, definition 5.2). Keeps its working memory from call to call. Results do not
/// depend on the number of threads.
class Cauchy {
 public:
  explicit Cauchy(const SumSettings& settings);
  ~Cauchy();

  /// The degenerate matrix: targets are the sources, and its diagonal is 0. Throws InputError where
  /// two points coincide.
  void at_sources(std::span<const Complex> points, std::span<const Complex> strengths,
                  std::span<Complex> result);
  /// Throws InputError where a target stands on a source.
  void at(std::span<const Complex> targets, std::span<const Complex> sources,
          std::span<const Complex> strengths, std::span<Complex> result);

 private:
  class Sum;
  std::unique_ptr<Sum> sum_;
};

}  // namespace mote
