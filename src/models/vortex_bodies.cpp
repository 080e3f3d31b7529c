#include "mote/models/vortex_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "mote/models/vortex_outlines.hpp"

namespace mote {
namespace {

PlaneVortices plane(const VortexParticles<2>& vortices) {
  return {vortices.position(), vortices.circulation()};
}

}  // namespace

VortexBodies::VortexBodies(const VortexOptions& options, const VortexParticles<2>& vortices)
    : free_stream_(options.free_stream, vortices.start()) {
  const SpaceStart& start = vortices.start();
  VortexOutlines bodies = vortex_outlines(start);
  numbers_ = std::move(bodies.number);
  VortexWallOptions walls{
      .spacing = start.spacing,
      .node = {start.lower[0] + start.spacing / 2, start.lower[1] + start.spacing / 2},
      .panel_length = options.panel_length,
      .viscosity = options.kinematic_viscosity,
      .threshold = options.threshold};
  for (const double circulation : vortices.circulation()) walls.circulation += circulation;
  walls_ = std::make_unique<VortexWalls>(bodies.outline, walls);
}

std::vector<double> VortexBodies::stream(double time) const {
  std::vector<double> stream(walls_->panel_places().size());
  free_stream_.add(walls_->panel_places(), time, stream);
  return stream;
}

void VortexBodies::add_velocity(const VortexParticles<2>& vortices, double time,
                                std::span<double> velocity) const {
  walls_->add_velocity(plane(vortices), stream(time), vortices.position(), velocity);
}

void VortexBodies::begin_step(const VortexParticles<2>& vortices, double time, double step) {
  has_hurried_ = has_hurried_ || step < walls_->settling_time();
  walls_->begin_step(plane(vortices), stream(time));
}

void VortexBodies::end_step(VortexParticles<2>& vortices, double time, double step) {
  from_start_ = time == 0;
  const auto release =
      from_start_ ? WallDiffusion::Release::at_start : WallDiffusion::Release::evenly;
  const VortexWalls::Replaced after =
      walls_->end_step(plane(vortices), stream(time + step), step, release);
  vortices.replace({after.position, after.circulation, after.area, {}});
}

std::vector<Reading> VortexBodies::readings() const {
  double slip = 0, circulation = 0;
  for (std::size_t k = 0; k < walls_->slip().size(); ++k) {
    slip = std::max(slip, std::abs(walls_->slip()[k]));
    circulation += walls_->slip()[k] * walls_->bodies().panels()[k].length();
  }
  const auto [x, y] = walls_->force();
  return {{"force_x", x}, {"force_y", y}, {"slip", slip}, {"sheet_circulation", circulation}};
}

Triple VortexBodies::force_on(std::size_t body) const {
  const auto found = std::ranges::find(numbers_, body);
  if (found == numbers_.end() || from_start_) return {};
  const auto [x, y] = walls_->force_on(static_cast<std::size_t>(found - numbers_.begin()));
  return {x, y, 0};
}

}  // namespace mote
