// Cost of sums over all pairs of random points in a square or cube, warm: a million by the
// multipole method, fewer pair by pair, and both where the one overtakes the other. Run by hand on
// a quiet machine: benchmark_sums --benchmark_repetitions=9

#include <benchmark/benchmark.h>
#include <omp.h>

#include <string>

#include "mote/sums/biot_savart.hpp"
#include "mote/sums/cauchy.hpp"
#include "mote/sums/gravity.hpp"
#include "mote/sums/power_series.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

std::vector<Complex> random_complex(Draws& draws, std::size_t count, Complex corner) {
  std::vector<Complex> values(count);
  for (Complex& value : values) value = corner + Complex(draws.uniform(0, 1), draws.uniform(0, 1));
  return values;
}

void report(benchmark::State& state, std::size_t targets, std::size_t sources) {
  using benchmark::Counter;
  const auto rate = Counter::kIsIterationInvariantRate;
  state.counters["points"] = Counter(static_cast<double>(targets), rate);
  state.counters["pairs"] =
      Counter(static_cast<double>(targets) * static_cast<double>(sources), rate);
}

void cauchy(benchmark::State& state, SumSettings settings, std::size_t count) {
  Draws draws(1);
  const auto points = random_complex(draws, count, 0);
  const auto strengths = random_complex(draws, count, {-0.5, -0.5});
  std::vector<Complex> result(count);
  Cauchy sum(settings);
  sum.at_sources(points, strengths, result);
  for (auto _ : state) sum.at_sources(points, strengths, result);
  report(state, count, count);
}

/// Targets in the square two to the right: a ratio of the radii of 0.47.
void series(benchmark::State& state, double tolerance, std::size_t count) {
  Draws draws(1);
  const auto sources = random_complex(draws, count, 0), targets = random_complex(draws, count, 2);
  const auto strengths = random_complex(draws, count, {-0.5, -0.5});
  std::vector<Complex> result(count);
  for (auto _ : state) power_series(targets, sources, strengths, tolerance, result);
  report(state, count, count);
}

template <int D>
void gravity(benchmark::State& state, SumSettings settings, std::size_t count) {
  Draws draws(1);
  const auto position = draws.uniform(count * D, 0, 1), mass = draws.uniform(count, 0, 1);
  std::vector<double> potential(count), gradient(count * D);
  Gravity<D> sum(settings);
  const auto form = [&] { sum.at_sources({position, mass}, {potential, gradient}); };
  form();
  for (auto _ : state) form();
  report(state, count, count);
}

template <int D>
void vortices(benchmark::State& state, SumSettings settings, std::size_t count) {
  Draws draws(1);
  const auto position = draws.uniform(count * D, 0, 1);
  const auto circulation = draws.uniform(count * (D == 2 ? 1 : 3), -1, 1);
  std::vector<double> velocity(count * D);
  BiotSavart<D> sum(settings, "gauss");
  const auto form = [&] { sum.at_sources({position, circulation, 1e-3}, {velocity, {}}); };
  form();
  for (auto _ : state) form();
  report(state, count, count);
}

template <class Work>
void add(const std::string& name, std::size_t count, int threads, Work work) {
  const auto full =
      name + "/points:" + std::to_string(count) + "/threads:" + std::to_string(threads);
  benchmark::RegisterBenchmark(full.c_str(),
                               [=](benchmark::State& state) {
                                 omp_set_num_threads(threads);
                                 work(state);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MinTime(0.1);
}

void add_sizes(SumSettings settings, std::size_t count, int threads) {
  const std::string method(sum_methods[static_cast<int>(settings.method)]);
  SumSettings coarser = settings;
  coarser.tolerance = 1e-6;
  add("cauchy/" + method, count, threads, [=](auto& s) { cauchy(s, settings, count); });
  add("gravity_3D/" + method, count, threads, [=](auto& s) { gravity<3>(s, coarser, count); });
}

void add_all(int threads) {
  constexpr SumSettings fast{SumMethod::multipole, 1e-8}, direct{SumMethod::direct};
  constexpr std::size_t million = 1000000;
  for (const std::size_t count : {100000ul, million, 4 * million}) add_sizes(fast, count, threads);
  add("series", million, threads, [](auto& s) { series(s, 1e-8, million); });
  add("vortices_2D/multipole", million, threads, [=](auto& s) { vortices<2>(s, fast, million); });
  add("vortices_3D/multipole", million, threads, [=](auto& s) { vortices<3>(s, fast, million); });
  add_sizes(direct, 40000, threads);
  for (const std::size_t count : {1000, 2000, 4000, 8000, 16000}) {
    add_sizes(direct, count, threads);
    add_sizes(fast, count, threads);
  }
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  for (const int threads : {1, 2}) mote::test::add_all(threads);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
