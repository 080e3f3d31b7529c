#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "mote/neighbours/neighbours.hpp"
#include "mote/neighbours/pair_order.hpp"
#include "mote/operators/terms/any_fluid_terms.hpp"
#include "mote/operators/terms/pair_lines.hpp"

namespace mote {

/// How the pair terms of a fluid are weighted; a coefficient of 0 leaves its term out.
template <int D>
struct FluidCoefficients {
  double smoothing_length = 0;
  double mass = 0;         ///< of every particle
  bool continuity = true;  ///< whether the density follows from pairs
  bool pressure = true;    ///< whether pressure acts between pairs
  double diffusion = 0;    ///< delta h c of the density diffusion [length^2/time]
  Vec<D> density_at_rest =
      Vec<D>::Zero();               ///< gradient of the density at rest, which does not diffuse
  double artificial_viscosity = 0;  ///< alpha h c rho0 [mass/(length^(D-2) length time)]
  double viscosity = 0;             ///< dynamic viscosity mu
};

/// What stands at a point, for the account of friction. A ghost's velocity carries the fluid's on
/// beyond a wall: friction with it counts half, since the other half is that of a mirrored fluid.
enum class PairRole : std::uint8_t { plain, beside_ghosts, ghost };

/// All points that pairs are made of, the receivers first.
template <int D>
struct PairPoints {
  std::span<const PairLine<D>> lines;
  std::span<const PairRole> roles;  ///< of every point
  /// The velocity at which the mass of every ghost moves, where it is not that of its line: none if
  /// it is for all.
  std::span<const Vec<D>> carrying = {};

  /// The velocity at which the mass of point i moves.
  Vec<D> carrying_velocity(std::size_t i) const {
    return roles[i] == PairRole::ghost && !carrying.empty() ? carrying[i] : lines[i].speed();
  }
};

/// What a pass over all pairs found beside the sums.
struct FluidPass {
  std::int64_t pairs = 0;  ///< within the support, once for each of its ends that is a receiver
  double dissipation = 0;  ///< power lost to viscosity [energy/time]
};

/// What a wall particle sees of the fluid, sums over its fluid neighbours with weights V_j W.
template <int D>
struct FluidSeen {
  double weight = 0;                 ///< sum of V_j W
  double pressure = 0;               ///< weighted mean
  Vec<D> offset = Vec<D>::Zero();    ///< sum of m W (x - x_j), over the weight
  Vec<D> velocity = Vec<D>::Zero();  ///< weighted mean
  Vec<D> shear = Vec<D>::Zero();     ///< slope of the velocity against distance from the surface
};

/// A wall particle's view: the plane of the wall's surface, and the velocity there. Fluid that is
/// nearer to the surface than `nearest` counts as that near: the slope of the velocity of one
/// particle that touches the wall is no more than that of a regular layer.
template <int D>
struct Surface {
  double depth = 0, nearest = 0;
  Vec<D> normal = Vec<D>::Zero();
  Vec<D> velocity = Vec<D>::Zero();
};

/// How much more pairs that come closer than a spacing count in the crowding of particles: by
/// 1 + weight (W_ij/W(spacing))^4 (Monaghan 2000; Sun et al. 2017, (10), with 0.2).
struct ClosePairs {
  double spacing = 1, weight = 0.2;
};

/// How regularly a particle's neighbours lie around it, and how the fluid varies there.
template <int D>
struct FluidSpread {
  Mat<D> moment = Mat<D>::Zero();    ///< -sum V_j F x x^T: the unit matrix well inside a fluid
  Vec<D> crowding = Vec<D>::Zero();  ///< sum V_j (1 + ...) grad W: points to where they crowd
  Mat<D> velocity = Mat<D>::Zero();  ///< sum V_j (u_j - u_i) (grad W)^T
  Vec<D> density = Vec<D>::Zero();   ///< sum V_j (rho_j - rho_i) grad W
};

/// The pair terms of a weakly compressible fluid in one pass, with F_ij = W'(r)/r < 0, V = m/rho,
/// x = x_i - x_j, u = u_i - u_j, for receivers i (Monaghan 1994; Colagrossi & Landrini 2003;
/// Molteni & Colagrossi 2009; Morris, Fox & Zhu 1997; Fourtakas et al. 2019):
///   D rho/Dt = rho_i sum V_j u.x F  -  2 delta h c sum V_j (rho_j - rho_i + x.grad rho_rest) F,
///   rho_i Du/Dt = sum V_j F [ -(p_i + p_j) x + alpha h c rho0 min(u.x, 0)/(r^2 + 0.01 h^2) x
///                             + 2 mu u ].
/// Every pair of receivers is met once, and what it adds to one end it takes from the other to the
/// last bit: the force V_i V_j F [...], since all particles have the same mass m, and the
/// diffusion's part of D ln rho/Dt, since V_j (rho_j - rho_i) = rho_i (V_i - V_j). So momentum is
/// kept. Where one end is a ghost, u of the first sum is that of the mass; see PairPoints.
template <int D>
class FluidTerms : public AnyFluidTerms {
 public:
  /// Support of the kernel in smoothing lengths.
  virtual double support() const = 0;

  /// Adds to the sums of all receivers. `lists` are the neighbours of the receivers, in the order
  /// of numbers, of which only those after the receiver itself are looked at, and `order` was
  /// arranged for these.
  virtual FluidPass add_up(const PairPoints<D>& points, const NeighbourLists& lists,
                           const PairOrder& order, const FluidCoefficients<D>& coefficients,
                           std::span<PairSums> sums) const = 0;

  /// The sums of one point over these neighbours.
  virtual PairSums sums_of(const PairPoints<D>& points, Index i, std::span<const Index> neighbours,
                           const FluidCoefficients<D>& coefficients) const = 0;

  /// Density by summation, sum m W_ij with the particle itself, of receiver i.
  virtual double density(std::span<const PairLine<D>> lines, Index i,
                         std::span<const Index> neighbours, double smoothing_length,
                         double mass) const = 0;

  /// What wall particle i sees of its fluid neighbours.
  virtual FluidSeen<D> seen(std::span<const PairLine<D>> lines, Index i,
                            std::span<const Index> neighbours, double smoothing_length, double mass,
                            const Surface<D>& surface) const = 0;

  /// sum V_j (a_i + a_j).(x_j - x_i) F_ij of receiver i for one vector a a point.
  virtual double linear_diffusion(std::span<const PairLine<D>> lines, Index i,
                                  std::span<const Index> neighbours, double smoothing_length,
                                  std::span<const Vec<D>> slopes) const = 0;

  /// How the neighbours of receiver i lie.
  virtual FluidSpread<D> spread(std::span<const PairLine<D>> lines, Index i,
                                std::span<const Index> neighbours, double smoothing_length,
                                double mass, const ClosePairs& close_pairs) const = 0;
};

}  // namespace mote
