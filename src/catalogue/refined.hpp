#pragma once

#include <functional>
#include <memory>

#include "mote/exact/exact_solution.hpp"
#include "mote/models/model.hpp"

namespace mote {

/// The model's own equations on finer cells, by the form of them that converges best: a reference
/// where no solution in closed form is known. What it is worth it says itself, by how far it is
/// from the same with cells and steps three times as long: a method of order 2 is 8 times closer to
/// its limit.
/// Every particle is the middle one of an odd number of pieces, so that no interpolation comes in.
class Refined final : public ExactSolution {
 public:
  static constexpr std::string_view name = "refined";
  static constexpr std::string_view summary =
      "the same equations on 9 or 27 times finer cells, where nothing is known in closed form";

  /// Makes the model with every cell of the scenario in this many pieces.
  using Make = std::function<std::unique_ptr<Model>(int pieces)>;

  Refined(Make make, Index count);

  std::string statement() const override;
  double valid_until() const override;
  double bytes_needed() const override;

  /// Throw NumericalFailure if the refined run breaks down before `time`.
  Table of_particles(double time) const override;
  Table at_places(std::span<const double> position, double time) const override;
  Table curve(double time) const override;

 private:
  /// The state at the last time that was asked for.
  struct State {
    double time = -1;
    std::unique_ptr<Model> fine;
    double velocity_error = 0, density_error = 0;  ///< estimated, relative L2
  };

  const State& at(double time) const;
  std::unique_ptr<Model> run(int pieces, int steps, double time) const;
  std::vector<double> middles(const Model& model, const std::string& field, int pieces) const;

  Make make_;
  Index count_;
  int pieces_;
  mutable State state_;
};

}  // namespace mote
