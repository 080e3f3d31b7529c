#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mote/catalogue/entries.hpp"
#include "mote/catalogue/flow_start.hpp"

namespace mote {

/// Integrals of a vorticity: its circulation, where its centre is, and the second moments about
/// that over the circulation.
struct VorticityMoments {
  double circulation = 0;
  std::array<double, 2> centre{};
  double square_x = 0, square_y = 0, product = 0;
};

/// What a flow of vortices in closed form needs to know of a start in the plane. All throw
/// InputError with the key `check.against`, in the name of the solution.
class VortexStart {
 public:
  VortexStart(const FlowSetup& setup, std::string solution);

  [[noreturn]] void refuse(const std::string& problem) const;
  /// A parameter of the model.
  double parameter(const std::string& name) const;
  const SpaceStart& space() const { return setup_.start; }
  /// Of the blobs, and the vorticity there, or anywhere.
  const std::vector<Triple>& places() const { return places_; }
  double vorticity(const Triple& place) const { return setup_.start.initial("vorticity", place); }
  bool has_vorticity() const { return highest() != 0; }
  /// The vorticity of the largest magnitude.
  double highest() const;
  /// Whether it has no other value but 0.
  bool is_uniform() const;
  VorticityMoments moments() const;
  /// Largest difference from a vorticity, over the highest of that one.
  double vorticity_difference(const std::function<double(const Triple&)>& expected) const;

  void need_unbounded_plane() const;
  void need_no_free_stream() const;
  void need_no_viscosity() const;
  /// No vortices that are given by themselves, and some vorticity of one sign at least.
  void need_vorticity_alone() const;

 private:
  const FlowSetup& setup_;
  std::string solution_;
  std::vector<Triple> places_;
};

}  // namespace mote
