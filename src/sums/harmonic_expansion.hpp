#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mote/sums/far_pairs.hpp"
#include "mote/sums/harmonic_rotation.hpp"

namespace mote {

using Vector3 = std::array<double, 3>;

/// A ball that holds the points of a node of a tree.
struct NodeBall {
  Vector3 centre;
  double radius;  ///< the unit of length of the node's expansion; above 0 for a local expansion
};

/// Points column by column, and the numbers that each of them carries.
struct PointColumns {
  std::array<const double*, 3> position;
  std::span<const double* const> strengths;  ///< one column a component
  std::size_t count;
};

struct ChildMultipole {
  const double* multipole;
  NodeBall ball;
};
struct ChildLocal {
  double* local;
  NodeBall ball;
};

/// Expansions of the potential sum_j m_j/|x - x_j| of each component about centres anywhere:
///   multipole, outside of a ball of radius a:  sum_n a^n/r^(n+1) sum_m M_n^m S_n^m(direction)
///   local, inside of a ball of radius b:       sum_l (r/b)^l sum_m L_l^m S_l^m(direction),
/// real, in the order of harmonic_layout.hpp, each component's coefficients one after the other.
/// M_n^m is at most the sum of |m_j|, L_l^m has the unit of the potential, so neither depends on
/// the unit of length. The radius of a source may be 0: all its points stand at the centre. That of
/// a target is a length to divide by: for a node of one point take any above 0 and below the
/// distance of its sources, such as a millionth of its parent's.
///
/// The object holds working memory, for one thread. Results do not depend on earlier calls.
class HarmonicExpansion {
 public:
  /// `degree` is at most `highest_degree`.
  HarmonicExpansion(int degree, int components);

  int degree() const { return degree_; }
  int components() const { return components_; }
  /// Numbers of one expansion.
  std::size_t coefficients() const { return place_of(components_); }

  /// Adds points to the multipole expansion of the ball they are in.
  void add_points(const PointColumns& points, const NodeBall& ball, double* multipole);
  /// Adds the multipole expansions of children to that of their parent.
  void shift_up(std::span<const ChildMultipole> children, const NodeBall& parent,
                double* multipole);
  /// Adds the field of distant sources, of at most the degree of the expansions, to the local
  /// expansion of a target of `radius`, those of like degrees eight at a time, with the highest
  /// degree of the eight. All degrees of the source go to all of the target: leaving out those that
  /// add up to more than the degree, as Dehnen does, saves at most a tenth of the time and makes
  /// the errors of two equal balls 5 to 300 times as large at degree 6 to 10. The balls of source
  /// and target must not touch.
  void translate(std::span<const FarPair<3>> sources, double radius, double* local);
  /// Adds the local expansion of a parent to those of its children.
  void shift_down(const double* local, const NodeBall& parent,
                  std::span<const ChildLocal> children);

 private:
  struct Batch;

  std::size_t place_of(int component) const {
    return static_cast<std::size_t>(component) * harmonic_count(degree_);
  }
  void sort_by_degree(std::span<const FarPair<3>> sources);
  void translate_batch(const Batch& batch, const Lanes& target_radius);
  void turn_in(const Batch& batch, int component, const Lanes& ratio);
  void turn_out(int degree, int component, const Lanes& first, const Lanes& ratio);
  void clear_sums(int degree);
  void add_sums(int degree, double* coefficients);
  void prepare_powers(const Lanes& ratio);

  int degree_, components_;
  AxisTurn turn_;
  std::vector<std::uint32_t> order_;            ///< sources by falling degree
  std::vector<Lanes> along_axis_, translated_;  ///< of one component
  std::vector<Lanes> sums_;                     ///< what eight sources at a time gave to the target
  std::vector<Lanes> strengths_;                ///< of eight points, by components
  std::array<Lanes, highest_degree + 1> powers_;
};

}  // namespace mote
