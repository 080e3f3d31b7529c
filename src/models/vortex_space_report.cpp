#include <fmt/format.h>

#include "mote/models/vortex.hpp"

namespace mote {
namespace {

void add_ring(const SpaceVortexMoments& m, const std::string& suffix,
              std::vector<Reading>& readings) {
  for (int d = 0; d < 3; ++d)
    readings.push_back({fmt::format("centre_{}{}", axis_names[d], suffix), m.centre()[d]});
  readings.push_back({"radius" + suffix, m.radius()});
}

}  // namespace

template <>
SpaceVortexMoments Vortex<3>::moments() const {
  return space_vortex_moments(vortices_);
}

/// Sums of alpha, of x cross alpha/2 and of x cross (x cross alpha)/3.
template <>
std::vector<Conserved> Vortex<3>::conserved() const {
  const SpaceVortexMoments m = moments();
  std::vector<Conserved> quantities;
  const auto add = [&](const char* name, const Vec<3>& value, double scale) {
    for (int d = 0; d < 3; ++d)
      quantities.push_back({fmt::format("{}_{}", name, axis_names[d]), value[d], scale});
  };
  add("circulation", m.circulation, m.magnitude);
  if (keeps_impulse()) add("impulse", m.impulse, m.impulse_scale);
  if (keeps_angular_impulse()) add("angular_impulse", m.angular_impulse, m.angular_scale);
  return quantities;
}

/// Where all vortices are, and each of several rings, as long as it is known who belongs to it.
template <>
std::vector<Reading> Vortex<3>::readings() const {
  const SpaceVortexMoments m = moments();
  std::vector<Reading> readings{{"vortices", static_cast<double>(vortices_.count())},
                                {"magnitude", m.magnitude}};
  if (const auto hamiltonian = induced_->hamiltonian(sources()))
    readings.push_back({"hamiltonian", *hamiltonian});
  add_ring(m, "", readings);
  if (options_.rings.size() < 2 || options_.remesh_every > 0) return readings;
  for (std::size_t k = 0; k < options_.rings.size(); ++k)
    add_ring(space_vortex_moments(vortices_,
                                  [&](Index i) {
                                    return vortices_.ring()[static_cast<std::size_t>(i)] ==
                                           static_cast<double>(k + 1);
                                  }),
             fmt::format("_{}", k), readings);
  return readings;
}

}  // namespace mote
