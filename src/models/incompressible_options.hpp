#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/models/body_force.hpp"
#include "mote/models/model.hpp"

namespace mote {

enum class PressureSource { divergence, density, mixed };
enum class PressureGradient { plain, repulsive, symmetric };
enum class PressureLaplacian { by_operator, mps };
enum class SurfaceTest { number_density, cone, missing_neighbours };

/// Options of the incompressible fluid; see `describe` for their meaning.
struct IncompressibleOptions {
  double density = 1;
  double kinematic_viscosity = 0;

  PressureSource source = PressureSource::mixed;
  double relaxation = 0.01;
  PressureGradient gradient = PressureGradient::plain;
  PressureLaplacian laplacian = PressureLaplacian::by_operator;

  bool tension = true;

  bool free_surface = true;
  SurfaceTest surface_test = SurfaceTest::number_density;
  double surface_threshold = 0.97;
  std::optional<double> mean_pressure;

  double shifting = 0;  ///< strength; 0: none
  double collision_distance = 0, restitution = 0.2;

  std::string solver;
  double tolerance = 1e-6;
  std::int64_t most_iterations = 500;

  BodyForceOptions body_force;

  IncompressibleOptions();
  void describe(Description& description);
};

/// `type: incompressible` in a scenario.
class IncompressibleRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "incompressible";
  static constexpr std::string_view summary =
      "flow of an incompressible fluid, whose pressure solves a Poisson equation (MPS, ISPH)";

  IncompressibleOptions options;

  bool lives_on_a_line() const override { return false; }
  bool steps_itself() const override { return true; }
  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields(int dimension) const override;
  std::vector<std::string> conserved_names(int dimension) const override;
  /// Mostly matrices, for the neighbours of usual operators.
  double bytes_a_particle(int dimension) const override { return dimension == 2 ? 5e3 : 1.5e4; }
  using ModelRecipe::make;
  std::unique_ptr<Model> make(SpaceSetup setup) const override;
};

}  // namespace mote
