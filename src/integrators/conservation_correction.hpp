#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/contevol.hpp"

namespace mote {

/// Corrects the relative velocity of two point masses by their energy and angular momentum. With
/// the separation r, the specific energy E and angular momentum L of the relative motion, the
/// potential phi(r) (-mu/r in space, mu ln r in the plane) and the velocity v' that a method found,
///   v = (L x r + sign(r.v') sqrt(2 r^2 (E - phi) - L^2) r) / r^2,
/// equation (3.3.10), corrected: section 3.4 takes the sign of a coordinate. The velocity of the
/// centre of mass stays. Where no radial velocity has that energy, at a turning point, it is 0;
/// there the root makes errors of a few 1e-8 of rounding.
class ConservationCorrection {
 public:
  /// As Integrator::missing_in.
  static std::string missing_in(System& system);

  /// Takes E and L of the state, if none have been taken yet.
  void see(System& system);
  void correct(System& system) const;

  std::vector<double> memory() const;
  void recall(std::span<const double> memory);

 private:
  struct Kept {
    double energy;
    Eigen::Vector3d angular_momentum;
  };
  std::optional<Kept> kept_;
};

/// A ContEvol method followed by that correction, after every step and along the path.
template <class Method>
class Corrected : public Method {
 public:
  std::string missing_in(System& system) const override {
    const std::string missing = Method::missing_in(system);
    return missing.empty() ? ConservationCorrection::missing_in(system) : missing;
  }

  void advance_one_step(System& system, double time, double step) override {
    correction_.see(system);
    Method::advance_one_step(system, time, step);
    correction_.correct(system);
  }

  void go_along_path(System& system, double part) override {
    Method::go_along_path(system, part);
    correction_.correct(system);
  }

  std::vector<double> memory() const override { return correction_.memory(); }
  void recall(std::span<const double> memory) override { correction_.recall(memory); }

 private:
  ConservationCorrection correction_;
};

class ContEvol1Corrected final : public Corrected<ContEvol1> {
 public:
  static constexpr std::string_view name = "contevol_1_corrected";
  static constexpr std::string_view summary =
      "order 5, contevol_1 with two bodies' energy and angular momentum kept";
  static constexpr int order = 5;
};

class ContEvol2DirectCorrected final : public Corrected<ContEvol2Direct> {
 public:
  static constexpr std::string_view name = "contevol_2_direct_corrected";
  static constexpr std::string_view summary =
      "order 5, contevol_2_direct with two bodies' energy and angular momentum kept";
  static constexpr int order = 5;
};

class ContEvol2IndirectCorrected final : public Corrected<ContEvol2Indirect> {
 public:
  static constexpr std::string_view name = "contevol_2_indirect_corrected";
  static constexpr std::string_view summary =
      "order 5, contevol_2_indirect with two bodies' energy and angular momentum kept";
  static constexpr int order = 5;
};

}  // namespace mote
