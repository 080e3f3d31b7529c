// Cost of expansions in three dimensions, in seconds a pair of nodes, a node or a point, by degree
// and components. Run by hand on a quiet machine.

#include <benchmark/benchmark.h>

#include <vector>

#include "mote/sums/harmonic_error.hpp"
#include "mote/sums/harmonic_field.hpp"
#include "support/harmonic_cloud.hpp"

namespace mote::test {
namespace {

constexpr NodeBall node{{0, 0, 0}, 0.5}, parent{{0.1, 0.2, -0.1}, 0.8};

void report(benchmark::State& state, const char* unit, std::size_t count) {
  state.counters[unit] =
      benchmark::Counter(static_cast<double>(count) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

std::size_t places(const HarmonicExpansion& expansion) { return expansion.coefficients(); }

void translate(benchmark::State& state) {
  constexpr std::size_t count = 64;
  HarmonicExpansion expansion(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  Draws draws(1);
  const auto multipoles = draws.uniform(count * places(expansion), -1, 1);
  std::vector<double> local(places(expansion));
  std::vector<FarPair<3>> sources;
  for (std::size_t i = 0; i < count; ++i)
    sources.push_back({&multipoles[i * places(expansion)],
                       {draws.uniform(-3, 3), draws.uniform(-3, 3), draws.uniform(2, 4)},
                       node.radius,
                       expansion.degree()});
  for (auto _ : state) {
    expansion.translate(sources, node.radius, local.data());
    benchmark::DoNotOptimize(local.data());
  }
  report(state, "per_pair", count);
}

void add_points(benchmark::State& state) {
  constexpr std::size_t count = 64;
  HarmonicExpansion expansion(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const HarmonicCloud cloud(count, node, Draws(2));
  for (auto _ : state) benchmark::DoNotOptimize(cloud.multipole(expansion, node));
  report(state, "per_point", count);
}

void shift_up(benchmark::State& state) {
  HarmonicExpansion expansion(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const auto child = Draws(3).uniform(places(expansion), -1, 1);
  std::vector<double> result(places(expansion));
  const std::vector<ChildMultipole> children(8, {child.data(), node});
  for (auto _ : state) expansion.shift_up(children, parent, result.data());
  report(state, "per_child", children.size());
}

void shift_down(benchmark::State& state) {
  HarmonicExpansion expansion(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const auto local = Draws(4).uniform(places(expansion), -1, 1);
  std::vector<double> result(places(expansion));
  const std::vector<ChildLocal> children(8, {result.data(), node});
  for (auto _ : state) expansion.shift_down(local.data(), parent, children);
  report(state, "per_child", children.size());
}

constexpr std::size_t packs_of_node = 8;

void potential_and_gradient(benchmark::State& state) {
  const auto degree = static_cast<int>(state.range(0));
  const auto local = Draws(5).uniform(harmonic_count(degree), -1, 1);
  const HarmonicCloud points(8, node, Draws(6));
  PotentialField field(degree);
  for (auto _ : state) {
    field.prepare(local.data(), node);
    for (std::size_t pack = 0; pack < packs_of_node; ++pack)
      benchmark::DoNotOptimize(field.at(points.lanes()));
  }
  report(state, "per_point", packs_of_node * lane_count);
}

void velocity_and_gradient(benchmark::State& state) {
  const auto degree = static_cast<int>(state.range(0));
  const auto local = Draws(7).uniform(3 * harmonic_count(degree), -1, 1);
  const HarmonicCloud points(8, node, Draws(6));
  CurlField field(degree);
  for (auto _ : state) {
    field.prepare(local.data(), node, true);
    for (std::size_t pack = 0; pack < packs_of_node; ++pack)
      benchmark::DoNotOptimize(field.with_gradient(points.lanes()));
  }
  report(state, "per_point", packs_of_node * lane_count);
}

void choose_degree(benchmark::State& state) {
  const auto ratios = Draws(8).uniform(64, 0.1, 0.35);
  for (auto _ : state)
    for (std::size_t i = 0; i + 1 < ratios.size(); ++i)
      benchmark::DoNotOptimize(degree_for({ratios[i], ratios[i + 1]}, 1e-6));
  report(state, "per_pair", ratios.size() - 1);
}

const std::vector<std::int64_t> degrees{3, 4, 6, 8, 10, 12, 16, 20, 30};

BENCHMARK(translate)->ArgsProduct({degrees, {1, 3}});
BENCHMARK(add_points)->ArgsProduct({{4, 6, 10, 20}, {1, 3}});
BENCHMARK(shift_up)->ArgsProduct({{4, 6, 10, 20}, {1, 3}});
BENCHMARK(shift_down)->ArgsProduct({{4, 6, 10, 20}, {1, 3}});
BENCHMARK(potential_and_gradient)->ArgsProduct({{4, 6, 10, 20}});
BENCHMARK(velocity_and_gradient)->ArgsProduct({{4, 6, 10, 20}});
BENCHMARK(choose_degree);

}  // namespace
}  // namespace mote::test

BENCHMARK_MAIN();
