#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mote/models/body_force.hpp"
#include "mote/models/model.hpp"

namespace mote {

enum class StateEquation { tait, linear };
enum class FluidDensity { continuity, summation };
enum class Derivatives { pairs, by_operator };
enum class Viscosity { none, morris, artificial, by_operator };
enum class DensityDiffusion { none, molteni, fourtakas, antuono };
enum class WallForm { extrapolated, dynamic };

/// Options of the weakly compressible fluid; see `describe` for their meaning.
struct WeaklyCompressibleOptions {
  double density = 1;
  double sound_speed = 0;
  StateEquation equation_of_state = StateEquation::linear;
  double exponent = 7;
  double background_pressure = 0;
  FluidDensity density_form = FluidDensity::continuity;
  Derivatives pressure = Derivatives::pairs;
  Derivatives divergence = Derivatives::pairs;

  Viscosity viscosity = Viscosity::none;
  double kinematic_viscosity = 0;
  double alpha = 0.02;

  DensityDiffusion diffusion = DensityDiffusion::fourtakas;
  double diffusion_strength = 0.1;

  double shifting = 0;  ///< strength; 0: none
  bool free_surface = true;

  BodyForceOptions body_force;
  WallForm walls = WallForm::extrapolated;

  void describe(Description& description);
};

/// `type: weakly_compressible` in a scenario.
class WeaklyCompressibleRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "weakly_compressible";
  static constexpr std::string_view summary =
      "flow of a fluid that is a little compressible, in two and three dimensions";

  WeaklyCompressibleOptions options;

  bool lives_on_a_line() const override { return false; }
  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields(int dimension) const override;
  std::vector<std::string> conserved_names(int dimension) const override;
  using ModelRecipe::make;
  std::unique_ptr<Model> make(SpaceSetup setup) const override;
};

}  // namespace mote
