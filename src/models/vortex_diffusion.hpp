#pragma once

#include <limits>
#include <memory>
#include <span>

#include "mote/models/vortex_neighbours.hpp"

namespace mote {

/// How friction changes vortices: by rates of their circulations, by moving them, or by growing
/// cores. The base class is a fluid without friction.
template <int D>
class VortexDiffusion {
 public:
  virtual ~VortexDiffusion() = default;

  virtual bool changes_circulation() const { return false; }
  /// d Gamma/dt of every vortex, or in space d alpha/dt.
  virtual void find_rates(const VortexParticles<D>& /*vortices*/, std::span<double> /*rate*/) {}
  /// At which the square of the core's size grows. [length^2/time]
  virtual double core_growth() const { return 0; }
  /// What happens to the vortices at the end of a step.
  virtual void end_step(VortexParticles<D>& /*vortices*/, double /*time*/, double /*step*/) {}

  /// Steps beyond this are unstable with forward_euler.
  virtual double longest_step() const { return std::numeric_limits<double>::infinity(); }
  virtual PairWork pair_work() const { return {}; }
};

/// The one that the options ask for; takes the operator of the set-up if it is `sph`.
template <int D>
std::unique_ptr<VortexDiffusion<D>> vortex_diffusion(const VortexOptions& options,
                                                     SpaceSetup& setup);

extern template std::unique_ptr<VortexDiffusion<2>> vortex_diffusion<2>(const VortexOptions&,
                                                                        SpaceSetup&);
extern template std::unique_ptr<VortexDiffusion<3>> vortex_diffusion<3>(const VortexOptions&,
                                                                        SpaceSetup&);

}  // namespace mote
