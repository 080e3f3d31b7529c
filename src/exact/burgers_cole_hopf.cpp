#include "mote/exact/burgers_cole_hopf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mote/exact/cole_hopf_paths.hpp"

namespace mote {
namespace {

/// Beyond it a place does not say which gas is there: from 1e-13 of the domain, 1e-3 have become.
constexpr double most_compression = 1e10;

double largest_of(const std::function<double(double)>& function, double lower, double upper) {
  constexpr int samples = 1000;
  double largest = 0;
  for (int k = 0; k <= samples; ++k)
    largest = std::fmax(largest, std::abs(function(lower + (upper - lower) * k / samples)));
  return largest;
}

/// Waves of a start that grows come from everywhere after a while, and there is no solution then.
void refuse_growth(const BurgersStart& start) {
  const double width = start.upper - start.lower;
  const auto around = [&](double widths) {
    return largest_of(start.velocity, start.lower - widths * width, start.upper + widths * width);
  };
  if (around(1000) > 8 * around(8))
    throw std::invalid_argument(
        "the start velocity grows beyond the domain, and waves from there would rule in it; keep "
        "it bounded, for example with clamp()");
}

const BurgersStart& checked(const BurgersStart& start) {
  if (!(start.viscosity > 0) || !std::isfinite(start.viscosity))
    throw std::invalid_argument("the viscosity must be positive");
  if (!(start.lower < start.upper)) throw std::invalid_argument("the domain has no length");
  if (start.particles.empty()) throw std::invalid_argument("there are no particles");
  refuse_growth(start);
  return start;
}

/// Middles between neighbours whose velocity or density differs by more than a fortieth of all.
std::vector<double> middles_of_steps(const std::vector<double>& labels, const Table& table) {
  constexpr double part = 1.0 / 40;
  std::vector<char> is_step(labels.size(), 0);
  for (const std::size_t column : {1, 2}) {
    const std::vector<double>& values = table[column].values;
    const auto [lowest, highest] = std::ranges::minmax(values);
    for (std::size_t i = 1; i < values.size(); ++i)
      if (std::abs(values[i] - values[i - 1]) > part * (highest - lowest)) is_step[i] = 1;
  }
  std::vector<double> middles;
  for (std::size_t i = 1; i < labels.size(); ++i)
    if (is_step[i]) middles.push_back(0.5 * (labels[i - 1] + labels[i]));
  return middles;
}

/// The values of two lists in the order of their labels.
std::vector<double> merged(const std::vector<double>& labels, const std::vector<double>& values,
                           const std::vector<double>& more_labels,
                           const std::vector<double>& more_values) {
  std::vector<double> all;
  for (std::size_t i = 0, k = 0; i < labels.size(); ++i) {
    while (k < more_labels.size() && more_labels[k] < labels[i]) all.push_back(more_values[k++]);
    all.push_back(values[i]);
  }
  return all;
}

}  // namespace

BurgersColeHopf::BurgersColeHopf(BurgersStart start)
    : start_(checked(start)),
      motion_(start_.velocity, start_.lower, start_.upper, start_.viscosity) {}

std::string BurgersColeHopf::statement() const {
  return fmt::format(
      "burgers_cole_hopf is the velocity of Cole and Hopf on the whole line at the viscosity {:g}, "
      "and the paths in it, to about 1e-12 of the largest values; it has no ends, so those of the "
      "domain count as an error where the exact velocity changes there",
      start_.viscosity);
}

/// Waves of speed U reach 6 U t + 2 sqrt(4 nu t n) from both sides together, with exp(-n)
/// negligible; the root of that for the length that a start can be known on.
double BurgersColeHopf::valid_until() const {
  constexpr double widths = 3990, negligible = 100;
  const double width = start_.upper - start_.lower;
  const double fastest =
      largest_of(start_.velocity, start_.lower - widths * width, start_.upper + widths * width);
  const double b = 2 * std::sqrt(4 * start_.viscosity * negligible), c = widths * width;
  const double root = 2 * c / (b + std::sqrt(b * b + 24 * fastest * c));
  return root * root;
}

/// Prepares for paths through these places.
void BurgersColeHopf::cover(std::span<const double> places, double time) const {
  const auto [lower, upper] = std::ranges::minmax(places);
  for (double last = -1; last != motion_.fastest();) {
    last = motion_.fastest();
    const double way = last * time;
    motion_.cover(lower - way, upper + way, time);
  }
}

Table BurgersColeHopf::table_of(std::span<const double> labels, double time) const {
  Table table{{"position", {}}, {"velocity", {}}, {"density", {}}};
  std::vector<FluidParticle> particles;
  for (const double label : labels) particles.push_back({label, 0});
  if (time > 0) {
    cover(labels, time);
    particles = followed(motion_, labels, time, Direction::forwards);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto [place, log_stretch] = particles[i];
    table[0].values.push_back(place);
    table[1].values.push_back(time > 0 ? motion_(place, time).velocity : start_.velocity(place));
    table[2].values.push_back(start_.density(labels[i]) * std::exp(-log_stretch));
  }
  return table;
}

Table BurgersColeHopf::of_particles(double time) const { return table_of(start_.particles, time); }

Table BurgersColeHopf::at_places(std::span<const double> position, double time) const {
  Table table{{"velocity", {}}, {"density", {}}};
  std::vector<FluidParticle> sources;
  for (const double place : position) sources.push_back({place, 0});
  if (time > 0 && !position.empty()) {
    cover(position, time);
    sources = followed(motion_, position, time, Direction::backwards);
  }
  for (std::size_t i = 0; i < position.size(); ++i) {
    const double place = position[i];
    table[0].values.push_back(time > 0 ? motion_(place, time).velocity : start_.velocity(place));
    // Followed backwards, the gas is stretched by the inverse.
    const auto [label, log_compression] = sources[i];
    table[1].values.push_back(log_compression < std::log(most_compression)
                                  ? start_.density(label) * std::exp(log_compression)
                                  : std::numeric_limits<double>::quiet_NaN());
  }
  return table;
}

Table BurgersColeHopf::curve(double time) const {
  constexpr int intervals = 200, halvings = 12;
  std::vector<double> labels;
  for (int k = 0; k <= intervals; ++k)
    labels.push_back(std::lerp(start_.lower, start_.upper, static_cast<double>(k) / intervals));
  Table table = table_of(labels, time);
  for (int k = 0; k < halvings; ++k) {
    const std::vector<double> between = middles_of_steps(labels, table);
    if (between.empty()) break;
    const Table more = table_of(between, time);
    for (std::size_t column = 0; column < table.size(); ++column)
      table[column].values = merged(labels, table[column].values, between, more[column].values);
    labels = merged(labels, labels, between, between);
  }
  return table;
}

}  // namespace mote
