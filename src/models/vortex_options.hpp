#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/models/model.hpp"

namespace mote {

/// How friction spreads vorticity.
enum class Diffusion { none, sph, particle_strength_exchange, core_spreading, random_walk };

/// What carries vorticity over to the lattice.
enum class Remeshing { m4_prime, gauss };

/// A vortex that is given by itself.
struct SingleVortex {
  std::vector<double> position;
  double circulation = 0;
};

/// How circulation stretches in space; see `describe`.
enum class Stretching { transposed, classical };

/// A ring whose core is a Gauss function, omega = Gamma/(pi core^2) exp(-(s/core)^2) at the
/// distance s from its circle.
struct VortexRing {
  std::vector<double> centre, normal{0, 0, 1};
  double radius = 1, core = 0.1, circulation = 1;
};

/// Options of the vortex method; see `describe` for their meaning.
struct VortexOptions {
  std::string core = "gauss";
  std::optional<double> overlap, core_size;

  std::string sum = "automatic";
  double tolerance = 1e-8;

  double kinematic_viscosity = 0;
  Diffusion diffusion = Diffusion::none;
  double floor = 1e-5;
  double exchange_range = 1.5;
  std::int64_t seed = 0;

  std::int64_t remesh_every = 0;  ///< steps; 0: never
  Remeshing remeshing = Remeshing::m4_prime;
  double threshold = 1e-8;

  double panel_length = 2.5;  ///< of walls, at most [spacings]

  std::vector<std::string> free_stream;
  std::vector<SingleVortex> vortices;
  std::vector<VortexRing> rings;
  std::optional<Stretching> stretching;

  void describe(Description& description);
  /// Refuses what does not go together in a fluid with walls, or without. Throws InputError.
  void check(int dimension, bool has_walls) const;
  bool stretches_as(Stretching form) const {
    return stretching.value_or(Stretching::transposed) == form;
  }
  /// Radius of the cores of blobs that stand so far apart.
  double core_radius(double spacing) const;
};

/// `type: vortex` in a scenario.
class VortexRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "vortex";
  static constexpr std::string_view summary =
      "vortex blobs in the unbounded plane, past bodies if there are any, or space, or in a plane "
      "box that is periodic both ways (VBM)";

  VortexOptions options;

  bool lives_on_a_line() const override { return false; }
  bool step_suffices() const override { return true; }
  bool needs_operator() const override { return options.diffusion == Diffusion::sph; }
  bool has_circulation() const override { return true; }
  std::optional<double> longest_side_of_walls() const override { return options.panel_length; }
  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields(int dimension) const override;
  std::vector<std::string> conserved_names(int dimension) const override;
  using ModelRecipe::make;
  std::unique_ptr<Model> make(SpaceSetup setup) const override;
};

}  // namespace mote
