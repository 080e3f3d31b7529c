// Cost of operators on a disordered cloud in 3D, in seconds a point and a directed pair, on one
// core: preparation and all weights of gradient and Laplacian. Run by hand on a quiet machine.
//
// The double sum of (30) is a product of two single sums: `sph/N` over N neighbours a point shows a
// time a pair that does not grow with N.

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>
#include <map>
#include <string>

#include "mote/neighbours/kd_tree.hpp"
#include "mote/operators/differential/all.hpp"
#include "mote/operators/differential/apply.hpp"
#include "mote/operators/kernels/all.hpp"
#include "mote/particles/lattice.hpp"

namespace mote::test {
namespace {

/// A cube of `side`^3 points on a lattice with 20 % jitter, and what lies around it within `reach`.
const Points<3>& cube(Index side, double reach) {
  static std::map<std::pair<Index, double>, Points<3>> made;
  Points<3>& points = made[{side, reach}];
  if (points.size() > 0) return points;
  points = lattice_points<3>({.lower = Vec<3>::Zero(),
                              .upper = Vec<3>::Constant(side),
                              .count = {side, side, side},
                              .jitter = 0.2,
                              .layers = static_cast<Index>(std::ceil(reach))});
  points.density.assign(points.length.size(), 1);
  points.mass = points.density;
  return points;
}

const NeighbourLists& neighbours(Index side, double reach) {
  static std::map<std::pair<Index, double>, NeighbourLists> found;
  NeighbourLists& lists = found[{side, reach}];
  if (lists.receivers() == 0) KdTreeSearch<3>().find(cube(side, reach), {.support = reach}, lists);
  return lists;
}

/// Prepares the operator and forms all its weights.
template <class Operator>
void all_weights(benchmark::State& state, Index side, double reach) {
  const Points<3>& points = cube(side, reach);
  const NeighbourLists& lists = neighbours(side, reach);
  Operator op;
  op.smoothing_length *= reach / op.neighbour_rule().reach();
  for (auto _ : state) {
    op.prepare(points, lists);
    for_each_row<Vec<3>>(lists, [&](Index i, auto, auto weights) {
      op.gradient_weights(i, weights);
      benchmark::DoNotOptimize(weights.data());
    });
    for_each_row<double>(lists, [&](Index i, auto, auto weights) {
      op.laplacian_weights(i, weights);
      benchmark::DoNotOptimize(weights.data());
    });
  }
  using benchmark::Counter;
  const auto flags = Counter::kIsIterationInvariantRate | Counter::kInvert;
  state.counters["neighbours"] = static_cast<double>(lists.pairs()) / points.receivers;
  state.counters["per_point"] = Counter(points.receivers, flags);
  state.counters["per_pair"] = Counter(static_cast<double>(lists.pairs()), flags);
}

template <class Operator>
void add(const std::string& name, Index side, double reach) {
  benchmark::RegisterBenchmark((name + "/" + std::to_string(side) + "^3").c_str(),
                               all_weights<Operator>, side, reach)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  using namespace mote::test;
  omp_set_num_threads(1);
  constexpr double sixty = 2.4;  // spacings to 60 neighbours
  add<mote::LeastSquares<3, 2>>("least_squares.2", 100, sixty);
  add<mote::CorrectedSph<3, mote::WendlandC2<3>>>("corrected_sph.wendland_c2", 100, sixty);
  add<mote::Sph<3, mote::WendlandC2<3>>>("sph.wendland_c2", 100, sixty);
  for (const double reach : {1.9, 2.4, 3.0, 3.8, 4.8})
    add<mote::Sph<3, mote::WendlandC2<3>>>("sph.wendland_c2, reach " + std::to_string(reach), 40,
                                           reach);
  add<mote::LeastSquares<3, 4>>("least_squares.4, reach 3.5", 40, 3.5);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
