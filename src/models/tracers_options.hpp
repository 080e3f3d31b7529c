#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mote/models/model.hpp"

namespace mote {

/// How tracers move.
enum class TracerMethod { streamlines, rates };

/// A quantity that the exact motion of every tracer keeps.
struct TracerInvariant {
  std::string name, formula;
};

/// Options of tracers; see `describe` for their meaning.
struct TracersOptions {
  std::vector<std::string> velocity;
  TracerMethod method = TracerMethod::streamlines;

  struct Mesh {
    std::optional<double> spacing;
    double jitter = 0;
    std::int64_t seed = 0;
  } mesh;

  std::vector<TracerInvariant> invariants;

  void describe(Description& description);
  /// Throws InputError for names that are no columns, or used twice.
  void check() const;
};

/// `type: tracers` in a scenario.
class TracersRecipe final : public ModelRecipe {
 public:
  static constexpr std::string_view name = "tracers";
  static constexpr std::string_view summary =
      "material points in a given velocity field, moved along the streamlines of its piecewise "
      "linear interpolant (X-IVAS), or by an integrator";

  TracersOptions options;

  bool lives_on_a_line() const override { return false; }
  bool needs_operator() const override { return false; }
  bool step_suffices() const override { return true; }
  bool steps_itself() const override { return options.method == TracerMethod::streamlines; }
  /// Streamlines serve any step, an integrator a Courant number of 1.
  double largest_courant_number() const override;
  OtherMemory other_memory(const SpaceStart& domain) const override;
  void describe(Description& description) override { options.describe(description); }
  std::vector<InitialField> initial_fields(int /*dimension*/) const override { return {}; }
  std::vector<std::string> conserved_names(int /*dimension*/) const override { return {}; }
  using ModelRecipe::make;
  std::unique_ptr<Model> make(SpaceSetup setup) const override;
};

}  // namespace mote
