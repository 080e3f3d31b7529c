#include "mote/catalogue/refined.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mote/integrators/velocity_verlet.hpp"
#include "mote/particles/failure.hpp"

namespace mote {
namespace {

constexpr int fine_steps = 2100;

double relative_distance(const std::vector<double>& values, const std::vector<double>& reference) {
  double distance = 0, size = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    distance += (values[i] - reference[i]) * (values[i] - reference[i]);
    size += reference[i] * reference[i];
  }
  return size > 0 ? std::sqrt(distance / size) : std::sqrt(distance);
}

}  // namespace

Refined::Refined(Make make, Index count)
    : make_(std::move(make)), count_(count), pieces_(count <= 150 ? 27 : 9) {}

std::string Refined::statement() const {
  const std::string worth =
      state_.time < 0
          ? ""
          : fmt::format(
                "; judged by a third as many cells and steps, it is itself off by about "
                "{:.1g} in velocity and {:.1g} in density (relative L2)",
                state_.velocity_error, state_.density_error);
  return fmt::format(
      "refined is the same gas, without smoothing or artificial viscosity, in {} times as many "
      "cells, {} steps{}",
      pieces_, fine_steps, worth);
}

double Refined::bytes_needed() const {
  constexpr double of_a_cell = 700;  // fields, rates, neighbours, and three factorised diagonals
  return of_a_cell * count_ * (pieces_ + pieces_ / 3);
}

double Refined::valid_until() const { return std::numeric_limits<double>::infinity(); }

std::unique_ptr<Model> Refined::run(int pieces, int steps, double time) const {
  std::unique_ptr<Model> model = make_(pieces);
  VelocityVerlet integrator;
  const double step = time / steps;
  try {
    for (int k = 0; k < steps && time > 0; ++k) {
      model->begin_step(k * step, step);
      integrator.advance_one_step(*model, k * step, step);
      model->end_step(k * step, step);
    }
    model->update_dependent_fields();
    model->inspect();
  } catch (const NumericalFailure& broken) {
    throw NumericalFailure(fmt::format("the refined reference broke down: {}", broken.what()), {0},
                           broken.cause());
  }
  return model;
}

std::vector<double> Refined::middles(const Model& model, const std::string& field,
                                     int pieces) const {
  const auto values = model.cloud().values(field);
  std::vector<double> middles;
  for (Index i = 0; i < count_; ++i) middles.push_back(values[i * pieces + pieces / 2]);
  return middles;
}

const Refined::State& Refined::at(double time) const {
  if (state_.time == time) return state_;
  state_.fine = run(pieces_, fine_steps, time);
  const auto coarse = run(pieces_ / 3, fine_steps / 3, time);
  const auto error = [&](const std::string& field) {
    return relative_distance(middles(*coarse, field, pieces_ / 3),
                             middles(*state_.fine, field, pieces_)) /
           8;
  };
  state_.velocity_error = error("velocity");
  state_.density_error = error("density");
  state_.time = time;
  return state_;
}

Table Refined::of_particles(double time) const {
  const Model& fine = *at(time).fine;
  Table table;
  for (const char* field : {"position", "velocity", "density"})
    table.push_back({field, middles(fine, field, pieces_)});
  return table;
}

/// Between the fine particles along straight lines; where there is no gas, density is 0 and the
/// velocity has no meaning.
Table Refined::at_places(std::span<const double> position, double time) const {
  const Cloud& cloud = at(time).fine->cloud();
  const auto x = cloud.position();
  Table table{{"velocity", {}}, {"density", {}}};
  for (const double place : position) {
    const auto above = std::ranges::upper_bound(x, place);
    const bool inside = above != x.begin() && above != x.end();
    const auto k = static_cast<std::size_t>(above - x.begin());
    for (Column& column : table) {
      const auto values = cloud.values(column.name);
      const double outside =
          column.name == "density" ? 0 : std::numeric_limits<double>::quiet_NaN();
      column.values.push_back(
          inside ? std::lerp(values[k - 1], values[k], (place - x[k - 1]) / (x[k] - x[k - 1]))
                 : outside);
    }
  }
  return table;
}

Table Refined::curve(double time) const {
  const Cloud& cloud = at(time).fine->cloud();
  Table table;
  for (const char* field : {"position", "velocity", "density"}) {
    const auto values = cloud.values(field);
    table.push_back({field, {values.begin(), values.end()}});
  }
  return table;
}

}  // namespace mote
