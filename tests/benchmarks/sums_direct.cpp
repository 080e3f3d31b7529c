// Speed of direct sums, in pairs a second, for points and for blobs of every core. Run by hand on a
// quiet machine, with OMP_NUM_THREADS=1 for the speed of one core.

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "mote/operators/cores/all.hpp"
#include "mote/sums/biot_savart.hpp"
#include "mote/sums/gravity.hpp"
#include "support/random.hpp"

namespace mote::test {
namespace {

constexpr SumSettings direct{.method = SumMethod::direct};
constexpr double core_size = 0.01;

/// Points in a unit box, and a part of them as targets, so that a pass is short.
template <int D>
struct Cloud {
  static constexpr std::size_t count = 100'000, target_count = 9'984;
  std::vector<double> position = Draws(1).uniform(count * D, 0, 1);
  std::vector<double> mass = Draws(2).uniform(count, 0.1, 1);
  std::vector<double> circulation = Draws(3).uniform(count * (D == 2 ? 1 : 3), -1, 1);
  std::vector<double> targets = Draws(4).uniform(target_count * D, 0, 1);
  std::vector<double> first = std::vector<double>(target_count * D);
  std::vector<double> second = std::vector<double>(target_count * D * D);

  std::span<double> potential() { return std::span(second).first(target_count); }
};

template <class Cloud>
void report(benchmark::State& state, const Cloud&) {
  state.counters["pairs_per_second"] =
      benchmark::Counter(static_cast<double>(Cloud::count) * Cloud::target_count,
                         benchmark::Counter::kIsIterationInvariantRate);
}

template <int D>
void velocity(benchmark::State& state, const std::string& core, bool with_gradient) {
  Cloud<D> cloud;
  BiotSavart<D> sum(direct, core);
  const Sources<D> sources{cloud.position, cloud.circulation, core_size};
  const auto gradient = with_gradient ? std::span(cloud.second) : std::span<double>();
  for (auto _ : state) sum.at(cloud.targets, sources, {cloud.first, gradient});
  report(state, cloud);
}

template <int D>
void gravity(benchmark::State& state, const std::string& core, bool with_potential) {
  Cloud<D> cloud;
  Gravity<D> sum(direct, core);
  const Sources<D> sources{cloud.position, cloud.mass, core_size};
  const auto potential = with_potential ? cloud.potential() : std::span<double>();
  for (auto _ : state) sum.at(cloud.targets, sources, {potential, cloud.first});
  report(state, cloud);
}

template <int D>
void add_benchmarks(const std::string& core) {
  const std::string name = core + "/" + std::to_string(D) + "D/";
  const auto add = [&](const char* what, auto run, bool more) {
    benchmark::RegisterBenchmark((name + what).c_str(), run, core, more)->UseRealTime();
  };
  add("velocity", velocity<D>, false);
  add("velocity_and_gradient", velocity<D>, true);
  add("gravity", gravity<D>, false);
  add("gravity_and_potential", gravity<D>, true);
}

void add_all(const std::string& core) {
  add_benchmarks<2>(core);
  add_benchmarks<3>(core);
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  mote::test::add_all("point");
  mote::for_each_type(mote::VortexCores{},
                      []<class Core>() { mote::test::add_all(std::string(Core::name)); });
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
