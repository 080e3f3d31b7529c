// Cost of operators on a line, in seconds a directed pair: neighbour search, preparation, and the
// gradient with weights taken a row at a time. Run by hand on a quiet machine.

#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "mote/neighbours/line.hpp"
#include "mote/operators/differential/apply.hpp"
#include "support/operators_on_a_line.hpp"

namespace mote::test {
namespace {

constexpr Index count = 100'000;

/// A regular line, all of whose points are receivers but a few at each end.
Points<1> regular_line() {
  constexpr Index beyond = 20;
  Points<1> points;
  points.resize(count + 2 * beyond, count);
  for (Index i = 0; i < points.size(); ++i) {
    points.position[i] = i < count ? i : i < count + beyond ? count - 1 - i : i - beyond;
    points.mass[i] = points.density[i] = points.length[i] = 1;
  }
  points.circulation = points.mass;
  points.vorticity = points.density;
  return points;
}

void report(benchmark::State& state, const NeighbourLists& lists) {
  state.counters["neighbours"] = static_cast<double>(lists.pairs()) / count;
  state.counters["per_pair"] = benchmark::Counter(
      static_cast<double>(lists.pairs()) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void search(benchmark::State& state, const NamedOperator& named) {
  const Points<1> points = regular_line();
  const auto op = named.make();
  LineSearch search;
  NeighbourLists lists;
  for (auto _ : state) search.find(points, op->neighbour_rule(), lists);
  report(state, lists);
}

void prepared_gradient(benchmark::State& state, const NamedOperator& named) {
  const Points<1> points = regular_line();
  const auto op = named.make();
  NeighbourLists lists;
  LineSearch().find(points, op->neighbour_rule(), lists);
  std::vector<double> field, slope(count);
  for (const double x : points.position) field.push_back(std::sin(1e-3 * x));
  for (auto _ : state) {
    op->prepare(points, lists);
    gradient<1>(*op, lists, field, slope);
    benchmark::DoNotOptimize(slope.data());
  }
  report(state, lists);
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  for (const auto& named : mote::test::operators_on_a_line()) {
    benchmark::RegisterBenchmark(("search/" + named.name).c_str(), mote::test::search, named)
        ->UseRealTime();
    benchmark::RegisterBenchmark(("gradient/" + named.name).c_str(), mote::test::prepared_gradient,
                                 named)
        ->UseRealTime();
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
