// Cost of a weakly compressible flow: slopes of kernels, one pass over all pairs, and whole steps
// of dam breaks with search, walls and density diffusion. Directed pairs are those within the
// support, each counted from both its ends. Run by hand on a quiet machine: benchmark_flow
// --benchmark_repetitions=5

#include <benchmark/benchmark.h>
#include <malloc.h>
#include <omp.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <string>

#include "mote/app/simulation.hpp"
#include "mote/neighbours/cell_grid.hpp"
#include "mote/operators/kernels/all.hpp"
#include "mote/operators/terms/fluid_terms_on.hpp"
#include "support/clouds.hpp"

namespace mote::test {
namespace {

using benchmark::Counter;

/// Of 1.3 spacings, so that 80 neighbours lie in a ball and 20 in a disk.
constexpr double smoothing_length = 1.3;

/// Wall-clock time of a loop, and what it says.
class Clock {
 public:
  void start() { start_ = std::chrono::steady_clock::now(); }
  void stop() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  Counter rate(double events) const { return {events / seconds_}; }

  /// How much faster two threads are than one thread was the last time.
  void compare(benchmark::State& state, const std::string& name, int threads) const {
    static std::map<std::string, double> alone;
    const double each = seconds_ / static_cast<double>(state.iterations());
    if (threads == 1) alone[name] = each;
    if (threads == 2 && alone.contains(name)) state.counters["speedup"] = alone[name] / each;
  }

 private:
  std::chrono::steady_clock::time_point start_;
  double seconds_ = 0;
};

/// Memory of this process by the name that Linux has for it. [bytes]
double memory(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == name + ":") {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The memory that is taken beyond what was taken at the start, at its peak.
class PeakMemory {
 public:
  PeakMemory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;  // forgets the peak
    before_ = memory("VmRSS");
  }
  double bytes() const { return memory("VmHWM") - before_; }

 private:
  double before_;
};

/// Slopes of a kernel eight at a time, at places that lie in the cache.
template <class Kernel>
void slopes(benchmark::State& state) {
  constexpr std::size_t packs = 256;
  const Kernel kernel;
  Draws draws(1);
  std::vector<Lanes> places(packs);
  for (Lanes& q : places) q = Lanes([&](auto) { return draws.uniform(0, kernel.support()); });
  for (auto _ : state) {
    Lanes sum = 0;
    for (const Lanes& q : places) sum += slope_over_q_of(kernel, q);
    benchmark::DoNotOptimize(sum);
  }
  state.counters["slopes"] = Counter(packs * lane_count, Counter::kIsIterationInvariantRate);
}

/// Fluid on a lattice with a little jitter, in the order of the grid, and who is whose neighbour.
template <int D>
struct Fluid {
  explicit Fluid(Index side) {
    const auto cloud = jittered_cloud<D>({.side = side, .jitter = 0.05, .variation = 0});
    CellGrid<D> grid;
    const double reach = 2 * smoothing_length;
    const auto place = grid.order(cloud.position, cloud.size(), reach);
    std::vector<double> position;
    Draws draws(2);
    for (const Index i : place) {
      PairLine<D> line;
      for (int d = 0; d < D; ++d) {
        position.push_back(line.value[PairLine<D>::position + d] = cloud.position[i * D + d]);
        line.value[PairLine<D>::velocity + d] = draws.uniform(-1, 1);
      }
      line.value[PairLine<D>::volume] = draws.uniform(0.99, 1.01);
      line.value[PairLine<D>::pressure] = draws.uniform(0, 1);
      lines.push_back(line);
    }
    grid.find(position, cloud.size(), reach, {}, ListForm::later, lists);
    order.arrange(lists);
  }

  std::vector<PairLine<D>> lines;
  NeighbourLists lists;
  PairOrder order;
};

/// One evaluation of all pair terms of a dam break.
template <int D>
void force_pass(benchmark::State& state, const std::string& name, Index side, int threads) {
  omp_set_num_threads(threads);
  const Fluid<D> fluid(side);
  const auto count = fluid.lines.size();
  const FluidTermsOn<D, WendlandC2<D>> terms;
  const FluidCoefficients<D> coefficients{
      .smoothing_length = smoothing_length, .mass = 1, .diffusion = 1, .artificial_viscosity = 1};
  std::vector<PairSums> sums(count);
  const std::vector<PairRole> roles(count);
  Clock clock;
  std::int64_t pairs = 0;
  const auto pass = [&] {
    return terms.add_up({fluid.lines, roles}, fluid.lists, fluid.order, coefficients, sums);
  };
  pass();
  for (auto _ : state) {
    clock.start();
    pairs += pass().pairs;
    clock.stop();
  }
  const auto passes = static_cast<double>(state.iterations());
  state.counters["particles"] = static_cast<double>(count);
  state.counters["neighbours"] = static_cast<double>(pairs) / passes / static_cast<double>(count);
  state.counters["pairs"] = clock.rate(static_cast<double>(pairs));
  state.counters["updates"] = clock.rate(passes * static_cast<double>(count));
  clock.compare(state, name, threads);
}

/// A scenario with so many spacings in one length.
Simulation dam_break(const std::string& file, Index spacings) {
  auto document = Document::from_file(file);
  document.set("constants.dx=1/" + std::to_string(spacings));
  const Catalogue catalogue = standard_catalogue();
  return Simulation(document, read_scenario(document, catalogue), catalogue, false);
}

/// Takes steps of a simulation one after the other.
class Stepper {
 public:
  explicit Stepper(Simulation& simulation) : simulation_(simulation) { simulation.start_afresh(); }

  void go_on() {
    const Step step = simulation_.next_step(1, ++number_, time_);
    simulation_.advance(time_, step.length);
    time_ = step.end;
  }

 private:
  Simulation& simulation_;
  std::int64_t number_ = 0;
  double time_ = 0;
};

/// Whole steps of a dam break from its first one on.
void steps(benchmark::State& state, const std::string& name, const std::string& file,
           Index spacings, int threads) {
  omp_set_num_threads(threads);
  const PeakMemory peak;
  Simulation simulation = dam_break(file, spacings);
  Stepper stepper(simulation);
  for (int warm = 0; warm < 5; ++warm) stepper.go_on();
  const Model& model = simulation.model();
  const std::int64_t before = model.pair_work().pairs;
  Clock clock;
  clock.start();
  for (auto _ : state) stepper.go_on();
  clock.stop();
  const auto count = static_cast<double>(model.cloud().count());
  state.counters["particles"] = count;
  state.counters["pairs"] = clock.rate(static_cast<double>(model.pair_work().pairs - before));
  state.counters["updates"] = clock.rate(static_cast<double>(state.iterations()) * count);
  state.counters["bytes_a_particle"] = peak.bytes() / count;
  clock.compare(state, name, threads);
}

template <class Work>
benchmark::internal::Benchmark* add(const std::string& name, int threads, Work work) {
  return benchmark::RegisterBenchmark((name + "/threads:" + std::to_string(threads)).c_str(),
                                      [=](auto& state) { work(state, name, threads); })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

template <int D>
void add_force_pass(const std::string& name, Index side) {
  for (const int threads : {1, 2})
    add(name, threads,
        [=](auto& state, auto& full, int t) { force_pass<D>(state, full, side, t); });
}

/// The same number of steps for any number of threads: what a step costs changes on the way.
void add_steps(const std::string& name, const std::string& file, Index spacings, int count) {
  for (const int threads : {1, 2})
    add(name, threads, [=](auto& state, auto& full, int t) {
      steps(state, full, file, spacings, t);
    })->Iterations(count);
}

void add_slopes() {
  for_each_kernel(Kernels{}, []<template <int> class Kernel>() {
    benchmark::RegisterBenchmark(("slopes/" + std::string(Kernel<3>::name)).c_str(),
                                 slopes<Kernel<3>>);
  });
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  using namespace mote::test;
  add_slopes();
  add_force_pass<3>("pass/3D/1e5", 46);
  add_force_pass<3>("pass/3D/1e6", 100);
  add_force_pass<2>("pass/2D/1e5", 316);
  add_steps("steps/3D/1e5", MOTE_DAM_BREAK_3D, 46, 100);
  add_steps("steps/3D/1.1e6", MOTE_DAM_BREAK_3D, 115, 20);
  add_steps("steps/2D/1e5", MOTE_DAM_BREAK_2D, 316, 100);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
