#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/models/clusters.hpp"
#include "mote/models/model.hpp"

namespace mote {

/// A body that is given by itself.
struct PointMass {
  double mass = 1;
  std::vector<double> position, velocity;  ///< no velocity: it is at rest
  std::string name = {};
  std::optional<double> radius = {};  ///< of a ball that collides with others
};

/// Options of bodies under their own gravity; see `describe` for their meaning.
struct BodiesOptions {
  double gravitational_constant = 1;

  std::string sum = "automatic";
  double tolerance = 1e-8;

  std::string core = "point";
  double core_size = 0;

  std::vector<PointMass> masses;
  std::vector<Cluster> clusters;

  void describe(Description& description);
  /// Throws InputError unless there are bodies, of so many dimensions.
  void check(int dimension) const;

  /// What a scenario calls a body, first the masses given by themselves: its key, and words.
  std::string key_of(std::size_t body) const;
  std::string name_of(std::size_t body) const;

 private:
  void check_masses(int dimension) const;
  void check_clusters(int dimension) const;
  std::size_t cluster_of(std::size_t body) const;
};

/// `type: bodies` in a scenario.
class BodiesRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "bodies";
  static constexpr std::string_view summary =
      "point masses under their own gravity, m ln r in 2D and -m/r in 3D, in unbounded space";

  BodiesOptions options;

  bool lives_on_a_line() const override { return false; }
  bool step_suffices() const override { return true; }
  bool needs_operator() const override { return false; }
  bool needs_domain() const override { return false; }
  std::optional<double> own_particles() const override;
  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields(int /*dimension*/) const override { return {}; }
  std::vector<std::string> conserved_names(int dimension) const override;
  using ModelRecipe::make;
  std::unique_ptr<Model> make(SpaceSetup setup) const override;
};

}  // namespace mote
