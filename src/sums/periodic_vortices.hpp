#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "mote/operators/differential/lanes.hpp"
#include "mote/sums/sum_settings.hpp"

namespace mote {

/// The velocity that vortices of a periodic box in the plane induce with all their images, pair by
/// pair, in O(N^2). Their circulations add up to 0, or else a uniform vorticity makes up for them;
/// the velocity has no mean over the box.
///
/// With periods L and H >= L, a = 2 pi y/L, t = 2 pi x/L, b = 2 pi H/L, a row of vortices along x
/// induces Gamma/(2 L) (-sinh a, sin t)/(cosh a - cos t). The rows m = -1, 0, 1 are summed so,
/// those beyond by their Fourier series with K_n = exp(-2 n b)/(1 - exp(-n b)), and the uniform
/// vorticity -Gamma/(L H) makes the sum periodic:
///   u = Gamma/(2 L) [-sum_m sinh a_m/(cosh a_m - cos t) + 4 sum_n K_n sinh(n a) cos(n t)]
///       + Gamma y/(L H),
///   v = Gamma/(2 L) [ sum_m sin t/(cosh a_m - cos t) + 4 sum_n K_n cosh(n a) sin(n t)],
/// a_m = a - m b. With |y| <= H/2 three terms of the series leave an error below 1e-16.
class PeriodicVortices {
 public:
  /// `core` is "point" or "gauss".
  PeriodicVortices(const std::array<double, 2>& widths, std::string_view core);

  /// At the sources themselves, 2 numbers each; a vortex does not move itself. Throws InputError
  /// for cores that their images would overlap.
  void at_sources(const Sources<2>& sources, std::span<double> velocity);

  /// The vorticity of gauss cores with their images, less its mean.
  void vorticity_at_sources(const Sources<2>& sources, std::span<double> vorticity);

 private:
  /// What pairs need of a point, as products of these: no pair needs a transcendental function.
  struct Point {
    double x, y;              ///< in the box
    double sine, cosine;      ///< of pi x/L
    double growing, falling;  ///< exp(+-pi y/L)
    double circulation;
  };
  struct Pack;
  struct Pair;

  void place(const Sources<2>& sources);
  Pack pack_at(std::size_t first) const;
  Pair pair_of(const Pack& targets, const Point& source) const;
  void add(const Pair& pair, double circulation, std::array<Lanes, 2>& sums) const;
  void add_core(const Pair& pair, double circulation, std::array<Lanes, 2>& sums) const;

  bool turned_;  ///< whether the box lies on its side, so that H >= L
  double length_, height_;
  std::array<double, 3> far_{};              ///< K_n
  double row_growth_, row_cosh_, row_sinh_;  ///< exp, cosh, sinh of b/2
  bool has_cores_;
  double core_size_ = 0;
  std::vector<Point> points_;
};

}  // namespace mote
