#pragma once

#include <span>
#include <string>
#include <vector>

namespace mote {

/// A named column of numbers.
struct Column {
  std::string name;
  std::vector<double> values;
};
using Table = std::vector<Column>;

/// A solution known in closed form, for the initial state that it was made from.
class ExactSolution {
 public:
  virtual ~ExactSolution() = default;

  /// One sentence that says what the solution is exact for.
  virtual std::string statement() const = 0;

  /// The last time for which there is an answer; later ones throw std::domain_error.
  virtual double valid_until() const = 0;

  /// Memory that its answers take beyond a few numbers a particle.
  virtual double bytes_needed() const { return 0; }

  /// Whether `of_particles` has an answer, and not `at_places` alone.
  virtual bool knows_particles() const { return true; }

  /// The fields of the same material points: what moving particles are compared with.
  virtual Table of_particles(double time) const = 0;

  /// The fields at fixed places: what standing points are compared with. Where there is no
  /// material a field that has no meaning there is NaN.
  virtual Table at_places(std::span<const double> position, double time) const = 0;

  /// The fields along the line as a curve to draw; the first column is the position. In space some
  /// particles to draw, whose first columns are their places.
  virtual Table curve(double time) const = 0;
};

}  // namespace mote
