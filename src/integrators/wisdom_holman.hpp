#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/kepler_motion.hpp"

namespace mote {

/// The map of Wisdom & Holman (1991, Astron. J. 102, 1528) for planets about a mass that outweighs
/// them all, and comes first: half a kick by what the planets do to each other, motion on Kepler's
/// orbits in Jacobi's coordinates, and half a kick. Its error is of order 2 in the step, times the
/// planets' part of the mass; two bodies move exactly. Symplectic.
///
/// Jacobi's coordinate of body k is its place from the centre of mass of those before it, whose
/// mass with its own is M_k; it goes round G M_k. What is left of the forces, with x from the first
/// body, a of the planets alone and F the force of the first body on a planet:
///   G M_k (q_k/|q_k|^3 - (m_0/M_(k-1)) x_k/|x_k|^3) + a_k
///     + (sum_(j>k) F_j - sum_(0<j<k) m_j a_j)/M_(k-1).
///
/// The coordinates are kept from step to step, and formed anew where somebody has changed the
/// system in between.
class WisdomHolman final : public Integrator {
 public:
  static constexpr std::string_view name = "wisdom_holman";
  static constexpr std::string_view summary =
      "order 2 times the planets' mass, exact for Kepler's orbits, for bodies around the first";
  static constexpr int order = 2;

  std::string missing_in(System& system) const override;
  void advance_one_step(System& system, double time, double step) override;

  std::int64_t own_evaluations() const override { return evaluations_; }

  /// Jacobi's coordinates, and the state that they belong to.
  std::vector<double> memory() const override;
  void recall(std::span<const double> memory) override;

 private:
  using Packs = std::vector<Pack>;
  using Vectors = std::vector<PackVector>;

  /// What the vectors of each body, from the second on, add to those of all.
  class Triangle {
   public:
    template <class Weight>
    Triangle(std::size_t count, Weight weight);
    void add(const Vectors& from, PackVector& to, std::size_t pack) const;

   private:
    std::size_t count_, packs_;
    Packs weight_;  ///< of every body all packs
  };

  /// What follows from the masses alone.
  struct Weights {
    explicit Weights(const PointMasses& masses);

    std::size_t count;
    std::vector<double> within;       ///< M_k
    Packs mass, pull, first_part;     ///< m_k, G M_k, m_0/M_(k-1); 0 where there is no planet
    double first_pull;                ///< G m_0
    std::vector<double> planet_pull;  ///< G m_k
    Triangle centre, before, outer, inner;
  };

  bool is_where_it_was_left(System& system) const;
  void take(System& system);
  void give(System& system);
  void update_kicks();
  PackVector pull_of_planets(std::size_t pack) const;
  void kick(double time);
  void drift(double time);

  std::optional<Weights> weights_;
  std::vector<double> left_place_, left_velocity_;            ///< of the system by the last step
  Vectors place_, velocity_;                                  ///< Jacobi's; of the first body idle
  std::array<double, 3> centre_place_{}, centre_velocity_{};  ///< of all the mass
  std::int64_t evaluations_ = 0;
  bool has_kicks_ = false;  ///< that belong to the places
  Vectors kick_;
  Vectors from_first_, planets_force_, first_force_;  ///< work
};

}  // namespace mote
