// Cost of the neighbour searches for a million points, sorting and full lists, warm. Run by hand on
// a quiet machine: benchmark_search --benchmark_repetitions=9

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>
#include <map>
#include <string>

#include "mote/neighbours/cell_grid.hpp"
#include "support/clouds.hpp"

namespace mote::test {
namespace {

enum class Order { random, lattice, cells };

/// A million points of unit spacing: at random places, or on a lattice.
template <int D>
Points<D> million_points(Order order) {
  constexpr Index side = D == 2 ? 1000 : 100;
  auto points = jittered_cloud<D>({.side = side, .jitter = 0, .variation = 0});
  points.receivers = points.size();
  Draws draws(1);
  for (double& x : points.position)
    if (order == Order::random) x = draws.uniform(0, side);
  return points;
}

/// How far 55 neighbours in 3D and 21 in 2D reach, in spacings.
template <int D>
constexpr double reach() {
  return D == 2 ? 2.585 : 2.359;
}

/// The same points in the order of the grid's cells.
template <int D>
void put_in_order(CellGrid<D>& grid, const Points<D>& points, std::vector<double>& position) {
  const auto order = grid.order(points.position, points.receivers, reach<D>());
  position.resize(points.position.size());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < order.size(); ++k)
    for (int d = 0; d < D; ++d)
      position[k * D + d] = points.position[static_cast<std::size_t>(order[k]) * D + d];
}

void report(benchmark::State& state, const NeighbourLists& lists) {
  state.counters["neighbours"] = static_cast<double>(lists.pairs()) / lists.receivers();
}

/// The search of this name, for points in any order.
template <int D>
void search(benchmark::State& state, const std::string& name, Order order, int threads) {
  omp_set_num_threads(threads);
  const auto points = million_points<D>(order);
  const auto search = make_search<D>(name);
  NeighbourLists lists;
  search->find(points, {.support = reach<D>()}, lists);
  for (auto _ : state) search->find(points, {.support = reach<D>()}, lists);
  report(state, lists);
}

/// The grid for points that it puts in order first, and for points that are in order.
template <int D>
void grid(benchmark::State& state, bool in_order, int threads) {
  omp_set_num_threads(threads);
  const auto points = million_points<D>(Order::random);
  CellGrid<D> grid;
  NeighbourLists lists;
  std::vector<double> position;
  put_in_order(grid, points, position);
  grid.find(position, points.receivers, reach<D>(), {}, ListForm::any_order, lists);
  for (auto _ : state) {
    if (!in_order) put_in_order(grid, points, position);
    grid.find(position, points.receivers, reach<D>(), {}, ListForm::any_order, lists);
  }
  report(state, lists);
}

template <class Work>
void add(const std::string& name, int threads, Work work) {
  const auto full = name + "/threads:" + std::to_string(threads);
  benchmark::RegisterBenchmark(full.c_str(), work)
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MinTime(0.1);
}

template <int D>
void add_all(int threads) {
  const auto in = std::to_string(D) + "D/";
  for (const char* name : {"cell_grid", "kd_tree"}) {
    add(in + name + "/random", threads,
        [=](auto& state) { search<D>(state, name, Order::random, threads); });
    add(in + name + "/lattice", threads,
        [=](auto& state) { search<D>(state, name, Order::lattice, threads); });
  }
  add(in + "order_and_find", threads, [=](auto& state) { grid<D>(state, false, threads); });
  add(in + "find_in_order", threads, [=](auto& state) { grid<D>(state, true, threads); });
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  for (const int threads : {1, 2}) {
    mote::test::add_all<3>(threads);
    mote::test::add_all<2>(threads);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
