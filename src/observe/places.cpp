// Probes that look at places: points, lines and gauges.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mote/observe/measures.hpp"
#include "mote/observe/surroundings.hpp"
#include "mote/particles/parallel.hpp"

namespace mote {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

template <int D>
Vec<D> vector_of(const std::vector<double>& place) {
  return Vec<D>::Map(place.data());
}

std::vector<FieldColumn> all_columns(const Probe& probe, const Cloud& cloud) {
  std::vector<FieldColumn> columns;
  for (const std::string& word : probe.fields)
    for (FieldColumn& column : columns_of(word, cloud)) columns.push_back(std::move(column));
  return columns;
}

double value_of(const FieldColumn& column, const std::vector<Share>& shares, const Cloud& cloud) {
  if (shares.empty()) return nothing;
  const auto values = cloud.values(column.field);
  double value = 0;
  for (const auto& [particle, part] : shares)
    value +=
        part *
        values[static_cast<std::size_t>(particle) * static_cast<std::size_t>(column.components) +
               static_cast<std::size_t>(column.component)];
  return value;
}

template <int D>
std::vector<Reading> at_point(const Probe& probe, const Triple& period, const Model& model) {
  const Vec<D> place = vector_of<D>(probe.at);
  const auto shares = Surroundings<D>(model, period, {place, place}).shares(place);
  std::vector<Reading> readings;
  for (const FieldColumn& column : all_columns(probe, model.cloud()))
    readings.push_back({probe.name + "_" + column.name, value_of(column, shares, model.cloud())});
  return readings;
}

/// The values of every column at every place of the line, column by column.
template <int D>
std::vector<std::vector<double>> line_values(const Probe& probe,
                                             const std::vector<FieldColumn>& columns,
                                             const Triple& period, const Model& model) {
  const Vec<D> from = vector_of<D>(probe.from), to = vector_of<D>(probe.to);
  const Surroundings<D> around(model, period, {from.cwiseMin(to), from.cwiseMax(to)});
  const auto points = static_cast<std::size_t>(probe.points);
  std::vector<std::vector<double>> values(columns.size(), std::vector<double>(points));
  const bool many = around.fluid().size() * points > parallel_from * std::size_t{100};
#pragma omp parallel for schedule(static) if (many)
  for (std::int64_t k = 0; k < probe.points; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(probe.points - 1);
    const auto shares = around.shares((1 - part) * from + part * to);
    for (std::size_t c = 0; c < columns.size(); ++c)
      values[c][static_cast<std::size_t>(k)] = value_of(columns[c], shares, model.cloud());
  }
  return values;
}

template <int D>
std::vector<Reading> on_line(const Probe& probe, const Triple& period, const Model& model) {
  const auto columns = all_columns(probe, model.cloud());
  const auto values = line_values<D>(probe, columns, period, model);
  std::vector<Reading> readings;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::string name = probe.name + "_" + columns[c].name;
    double least = nothing, largest = nothing;
    for (const double value : values[c]) {
      least = std::fmin(least, value);  // of a number and NaN it is the number
      largest = std::fmax(largest, value);
    }
    readings.push_back({name + "_min", least});
    readings.push_back({name + "_max", largest});
    for (std::size_t k = 0; probe.all && k < values[c].size(); ++k)
      readings.push_back({fmt::format("{}_{}", name, k), values[c][k]});
  }
  return readings;
}

/// Where the filled part falls below one half last on the way up from `full` to `empty`.
template <int D>
double crossing(const Surroundings<D>& around, Vec<D> place, double full, double empty) {
  constexpr int halvings = 40;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (full + empty);
    place[D - 1] = middle;
    (around.filled(place) >= 0.5 ? full : empty) = middle;
  }
  return 0.5 * (full + empty);
}

/// Looks down from above the fluid in steps of a quarter of a spacing, which miss no layer of it.
template <int D>
double surface_above(const Probe& probe, const Triple& period, const Model& model) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  Box<D> column;
  for (int d = 0; d < D - 1; ++d)
    column.lower[d] = column.upper[d] = probe.at[static_cast<std::size_t>(d)];
  column.lower[D - 1] = -endless;
  column.upper[D - 1] = endless;
  Triple sideways = period;
  sideways[D - 1] = 0;
  const Surroundings<D> around(model, sideways, column);
  double top = -endless, bottom = endless;
  for (const Seen<D>& seen : around.fluid()) {
    top = std::max(top, seen.position[D - 1]);
    bottom = std::min(bottom, seen.position[D - 1]);
  }
  const double step = 0.25 * model.spacing();
  Vec<D> place = column.lower;
  for (double z = top + sight * model.spacing(); z >= bottom; z -= step) {
    place[D - 1] = z;
    if (around.filled(place) >= 0.5) return crossing<D>(around, place, z, z + step);
  }
  return nothing;
}

}  // namespace

std::vector<Reading> point_readings(const Probe& probe, const Triple& period, const Model& model) {
  return model.cloud().dimension() == 2 ? at_point<2>(probe, period, model)
                                        : at_point<3>(probe, period, model);
}

std::vector<Reading> line_readings(const Probe& probe, const Triple& period, const Model& model) {
  return model.cloud().dimension() == 2 ? on_line<2>(probe, period, model)
                                        : on_line<3>(probe, period, model);
}

std::vector<Reading> gauge_readings(const Probe& probe, const Triple& period, const Model& model) {
  return {{probe.name, model.cloud().dimension() == 2 ? surface_above<2>(probe, period, model)
                                                      : surface_above<3>(probe, period, model)}};
}

}  // namespace mote
