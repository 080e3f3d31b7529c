#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "mote/quantum/wave_pieces.hpp"

namespace mote {

/// The stationary Schroedinger equation -psi'' + V psi = E psi on a line, in units with
/// hbar^2/2m = 1, section 4 of the ContEvol paper.
struct SchroedingerProblem {
  std::function<double(double)> potential;
  double lower = 0, upper = 1;
  int intervals = 8;  ///< of equal length
  WaveForm form = WaveForm::plain;
  /// How fast psi falls beyond the ends; where there is none, psi is 0 at the end: a wall.
  std::optional<double> decay_below, decay_above;
};

/// The equation as -Q psi = E P psi for values and slopes at the nodes: with phi = H psi taken from
/// the same functions as psi, the cost
///   integral of (phi + psi'' - V psi)^2
/// is least for P phi = -Q psi, equations (4.2.8) and (4.2.9). The functions that share psi's
/// conditions at the ends are what is left of the matrices: where psi is 0, its row and column are
/// deleted; where it has a tail, its slope is tied to its value (section 4.4; with a tail of slope
/// 0 the row and column of the slope are deleted, against the text).
struct SchroedingerMatrices {
  Eigen::MatrixXd p, q;   ///< of the unknowns that are left
  Eigen::MatrixXd nodal;  ///< value and slope at every node in turn, of these unknowns
};

SchroedingerMatrices schroedinger_matrices(const SchroedingerProblem& problem);

/// The states of lowest energy, normalised and orthogonal with their tails.
class StationaryStates {
 public:
  /// Throws std::domain_error for a problem without an interval or of more states than unknowns,
  /// and NumericalFailure where the numbers of the problem are too large or too small.
  StationaryStates(const SchroedingerProblem& problem, int count);

  int count() const { return static_cast<int>(energies_.size()); }
  const Eigen::VectorXd& energies() const { return energies_; }

  /// Wave function of one state, from 0 on, anywhere on the line. Its largest lobe from below is
  /// positive at first.
  double wave_function(int state, double x) const;

 private:
  SchroedingerProblem problem_;
  Eigen::VectorXd energies_;
  Eigen::MatrixXd nodal_;  ///< of every state a column
};

}  // namespace mote
