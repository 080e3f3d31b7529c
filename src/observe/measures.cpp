#include "mote/observe/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/particles/failure.hpp"

namespace mote {
namespace {

/// Calls `visit` with the number of every particle of the fluid, in order.
template <class Visit>
void for_each_of_the_fluid(const Model& model, const Visit& visit) {
  const auto body = model.cloud().values("body");
  for (std::size_t i = 0; i < body.size(); ++i)
    if (model.bodies()[static_cast<std::size_t>(body[i])].kind == BodyKind::fluid) visit(i);
}

}  // namespace

std::vector<Reading> front_readings(const Probe& probe, const Model& model) {
  const auto dimension = static_cast<std::size_t>(model.cloud().dimension());
  const auto axis = static_cast<std::size_t>(probe.along.back() - 'x');
  const double sign = probe.along.front() == '-' ? -1 : 1;
  double furthest = -std::numeric_limits<double>::infinity();
  for_each_of_the_fluid(model, [&](std::size_t i) {
    furthest = std::max(furthest, sign * model.cloud().position()[i * dimension + axis]);
  });
  return {{probe.name, sign * (furthest + 0.5 * model.spacing())}};
}

std::vector<Reading> speed_readings(const Probe& probe, const Model& model) {
  const auto dimension = static_cast<std::size_t>(model.cloud().dimension());
  const auto velocity = model.cloud().values("velocity");
  double largest = 0, sum = 0, count = 0;
  for_each_of_the_fluid(model, [&](std::size_t i) {
    double square = 0;
    for (std::size_t d = 0; d < dimension; ++d)
      square += velocity[i * dimension + d] * velocity[i * dimension + d];
    largest = std::max(largest, square);
    sum += square;
    ++count;
  });
  return {{probe.name + "_max", std::sqrt(largest)},
          {probe.name + "_rms", count > 0 ? std::sqrt(sum / count) : 0}};
}

std::size_t wall_named(const std::string& name, const Model& model) {
  std::string walls;
  for (std::size_t b = 0; b < model.bodies().size(); ++b) {
    const Body& body = model.bodies()[b];
    if (body.kind != BodyKind::wall) continue;
    if (body.name == name) return b;
    walls += (walls.empty() ? "" : ", ") + body.name;
  }
  throw InputError(
      fmt::format("there is no wall '{}'; there are: {}", name, walls.empty() ? "none" : walls));
}

std::vector<Reading> force_readings(const Probe& probe, const Model& model) {
  const Triple force = model.force_on(wall_named(probe.wall, model));
  std::vector<Reading> readings;
  for (int d = 0; d < model.cloud().dimension(); ++d)
    readings.push_back({probe.name + "_" + axis_names[d], force[static_cast<std::size_t>(d)]});
  return readings;
}

std::vector<FieldColumn> columns_of(const std::string& word, const Cloud& cloud) {
  for (const Field& field : cloud.fields()) {
    if (field.kind == FieldKind::scalar && field.name == word) return {{word, word}};
    if (field.kind != FieldKind::vector) continue;
    std::vector<FieldColumn> columns;
    for (int c = 0; c < field.components; ++c)
      columns.push_back({field.name + "_" + axis_names[c], field.name, c, field.components});
    if (field.name == word) return columns;
    const auto one = std::ranges::find(columns, word, &FieldColumn::name);
    if (one != columns.end()) return {*one};
  }
  throw InputError(fmt::format("the model's particles have no {}", word));
}

}  // namespace mote
