#pragma once

#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// A standing wave in a tank; x along the first axis, z up along the last one.
struct WaveTank {
  double density = 1;
  double gravity = 1;      ///< downwards, positive
  double viscosity = 0;    ///< kinematic
  double bottom = 0;       ///< z of the bottom
  double depth = 1;        ///< H of the water at rest
  double wave_number = 1;  ///< k [1/length]
  double phase = 0;        ///< a in cos(k x + a)
  double elevation = 0;    ///< of the surface at the start, at the crest of cos(k x + a)
  double rise = 0;         ///< its rate at the start
};

/// Small gravity waves by linear theory (Lamb 1932, sections 227 to 228): the surface
///   eta = E(t) cos(k x + a),  E'' = -omega^2 E,  omega^2 = g k tanh(k H),
/// over the potential phi = E'(t) cosh(k (z - bottom))/(k sinh(k H)) cos(k x + a), from which
///   u = phi_x, w = phi_z, p = rho (g (surface at rest - z) - phi_t).
/// Viscosity takes the share 4 nu k^2 of the energy in unit time (section 348), amplitudes the half
/// of it; for walls and a bottom along which the fluid slips that holds at any depth.
class StandingWave final : public FlowSolution {
 public:
  static constexpr std::string_view name = "standing_wave";
  static constexpr std::string_view summary =
      "small standing waves on water of finite depth, by linear theory";

  explicit StandingWave(const WaveTank& tank);

  double frequency() const { return frequency_; }  ///< omega [1/time]
  /// Height of the surface above its rest at this x.
  double elevation(double x, double time) const;

  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;

 private:
  FlowState at(double x, double z, int last_axis, double time) const;
  /// E and E' for the motion without viscosity, times the decay.
  double height(double time) const;
  double rise(double time) const;

  WaveTank tank_;
  double frequency_;
};

}  // namespace mote
