#include "mote/exact/gravitating_sheets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace mote {
namespace {

using std::numbers::pi;

/// First positive root of a + b t + c t^2 for a > 0; infinite if there is none.
double first_root(double a, double b, double c) {
  constexpr double never = std::numeric_limits<double>::infinity();
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return never;
  // Both roots, a/q and q/c, without a difference of nearly equal numbers.
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  double first = never;
  for (const double root : {a / q, q / c})
    if (root > 0 && root < first) first = root;
  return first;
}

}  // namespace

GravitatingSheets::GravitatingSheets(SheetCells cells) : cells_(std::move(cells)) {
  const std::size_t count = cells_.position.size();
  for (const auto* values : {&cells_.velocity, &cells_.length, &cells_.length_rate, &cells_.mass})
    if (values->size() != count) throw std::invalid_argument("cells differ in number");
  if (count == 0 || std::ranges::min(cells_.length) <= 0)
    throw std::invalid_argument("every cell needs a length");
  for (std::size_t i = 0; i < count; ++i) {
    mass_below_.push_back(total_mass_ + 0.5 * cells_.mass[i]);
    total_mass_ += cells_.mass[i];
  }
  first_velocity_ = cells_.velocity[0] - 0.5 * cells_.length_rate[0];
  first_crossing_ = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const double half_fall = -2 * pi * cells_.gravity * cells_.mass[i];
    first_crossing_ =
        std::min(first_crossing_, first_root(cells_.length[i], cells_.length_rate[i], half_fall));
    if (i == 0) continue;
    first_crossing_ = std::min(
        first_crossing_,
        first_root(cells_.position[i] - cells_.position[i - 1],
                   cells_.velocity[i] - cells_.velocity[i - 1],
                   0.5 * (acceleration(mass_below_[i]) - acceleration(mass_below_[i - 1]))));
  }
}

void GravitatingSheets::refuse_after_crossing(double time) const {
  if (time < first_crossing_) return;
  throw std::domain_error(
      fmt::format("the first sheets cross at t = {:.6g}: there is no solution at t = {:.6g}",
                  first_crossing_, time));
}

double GravitatingSheets::acceleration(double mass_below) const {
  return -4 * pi * cells_.gravity * (mass_below - 0.5 * total_mass_);
}

double GravitatingSheets::length(std::size_t i, double time) const {
  return cells_.length[i] + cells_.length_rate[i] * time -
         2 * pi * cells_.gravity * cells_.mass[i] * time * time;
}

std::string GravitatingSheets::statement() const {
  return fmt::format(
      "gravitating_sheets is the exact motion of {} cells of gas, each with the density at its "
      "middle; how well they stand for the density between is another matter",
      cells_.position.size());
}

Table GravitatingSheets::of_particles(double time) const {
  refuse_after_crossing(time);
  Table table{{"position", {}}, {"velocity", {}}, {"density", {}}};
  for (std::size_t i = 0; i < cells_.position.size(); ++i) {
    const double g = acceleration(mass_below_[i]);
    table[0].values.push_back(cells_.position[i] + cells_.velocity[i] * time +
                              0.5 * g * time * time);
    table[1].values.push_back(cells_.velocity[i] + g * time);
    table[2].values.push_back(cells_.mass[i] / length(i, time));
  }
  return table;
}

GravitatingSheets::Edges GravitatingSheets::edges(double time) const {
  const double g = acceleration(0);
  Edges edges{{cells_.lower + first_velocity_ * time + 0.5 * g * time * time},
              {first_velocity_ + g * time}};
  for (std::size_t i = 0; i < cells_.length.size(); ++i) {
    edges.position.push_back(edges.position.back() + length(i, time));
    edges.velocity.push_back(edges.velocity.back() + cells_.length_rate[i] -
                             4 * pi * cells_.gravity * cells_.mass[i] * time);
  }
  return edges;
}

Table GravitatingSheets::at_places(std::span<const double> position, double time) const {
  refuse_after_crossing(time);
  const Edges edge = edges(time);
  Table table{{"velocity", {}}, {"density", {}}};
  for (const double x : position) {
    const auto above = std::ranges::upper_bound(edge.position, x);
    if (above == edge.position.begin() || above == edge.position.end()) {
      table[0].values.push_back(std::numeric_limits<double>::quiet_NaN());
      table[1].values.push_back(0);
      continue;
    }
    const auto i = static_cast<std::size_t>(above - edge.position.begin()) - 1;
    const double part = (x - edge.position[i]) / (edge.position[i + 1] - edge.position[i]);
    table[0].values.push_back(std::lerp(edge.velocity[i], edge.velocity[i + 1], part));
    table[1].values.push_back(cells_.mass[i] / length(i, time));
  }
  return table;
}

Table GravitatingSheets::curve(double time) const {
  refuse_after_crossing(time);
  const Edges edge = edges(time);
  Table table{{"position", {}}, {"velocity", {}}, {"density", {}}};
  for (std::size_t i = 0; i < cells_.length.size(); ++i)
    for (const std::size_t side : {i, i + 1}) {
      table[0].values.push_back(edge.position[side]);
      table[1].values.push_back(edge.velocity[side]);
      table[2].values.push_back(cells_.mass[i] / length(i, time));
    }
  return table;
}

}  // namespace mote
