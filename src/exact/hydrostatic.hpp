#pragma once

#include <string_view>

#include "mote/exact/flow_solution.hpp"

namespace mote {

/// A fluid at rest below a free surface: grad p = rho g, so p = rho g . (x - x_surface) with the
/// place `surface` anywhere on the free surface. Constant density.
class Hydrostatic final : public FlowSolution {
 public:
  static constexpr std::string_view name = "hydrostatic";
  static constexpr std::string_view summary = "a fluid at rest below a free surface, under gravity";

  Hydrostatic(double density, const std::array<double, 3>& gravity,
              const std::array<double, 3>& surface)
      : density_(density), gravity_(gravity), surface_(surface) {}

  std::string statement() const override;
  Table at_places(std::span<const double> position, int dimension, double time) const override;

 private:
  double density_;
  std::array<double, 3> gravity_, surface_;
};

}  // namespace mote
