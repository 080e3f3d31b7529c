#include <benchmark/benchmark.h>

#include <numbers>

#include "integrators/point_masses.hpp"
#include "mote/integrators/all.hpp"
#include "mote/models/few_bodies.hpp"

namespace mote::test {
namespace {

/// The Sun and the giant planets, whose accelerations are formed as a model of bodies forms them.
class Planets final : public System {
 public:
  std::span<const Evolving> drifted() override { return drifted_; }
  std::span<const Evolving> kicked() override { return kicked_; }
  bool drifts_freely() const override { return true; }
  bool falls_freely() const override { return true; }
  int dimension() const override { return 3; }
  std::optional<PointMasses> point_masses() const override {
    return PointMasses{start_.constant, start_.mass};
  }
  void prepare(double) override {}
  void update_drift_rates(double) override {}
  void update_kick_rates(double) override {
    ++evaluations;
    few_bodies::accelerate<3>(start_.constant, start_.mass, start_.position, start_.acceleration);
  }

  double evaluations = 0;

 private:
  MassPoints start_ = giants();
  std::array<Evolving, 1> drifted_{{{start_.position, start_.velocity}}};
  std::array<Evolving, 1> kicked_{{{start_.velocity, start_.acceleration}}};
};

/// One step of 40 days, or as the method chooses.
template <class Method>
void step_of_the_planets(benchmark::State& state) {
  Planets planets;
  Method method;
  for (auto _ : state) benchmark::DoNotOptimize(method.advance(planets, 0, 40));
  state.counters["evaluations a step"] =
      benchmark::Counter(planets.evaluations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(step_of_the_planets<VelocityVerlet>);
BENCHMARK(step_of_the_planets<RungeKutta4>);
BENCHMARK(step_of_the_planets<WisdomHolman>);

/// Ten thousand years of the planets by Gauss-Radau; the argument is 1e10 times the tolerance.
void ten_thousand_years(benchmark::State& state) {
  double evaluations = 0, steps = 0;
  for (auto _ : state) {
    Planets planets;
    GaussRadau15 method;
    method.tolerate(1e-10 * static_cast<double>(state.range(0)));
    constexpr double end = 3652500;
    for (double now = 0; now < end; ++steps) now += method.advance(planets, now, end - now);
    evaluations += planets.evaluations;
  }
  state.counters["steps"] = benchmark::Counter(steps, benchmark::Counter::kAvgIterations);
  state.counters["evaluations"] =
      benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}
BENCHMARK(ten_thousand_years)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

/// A period of an orbit of eccentricity 0.9, and how far from its start it ends.
void once_round(benchmark::State& state) {
  double evaluations = 0, error = 0;
  for (auto _ : state) {
    MassPoints bodies = kepler(0.9);
    const std::vector<double> start = bodies.position;
    GaussRadau15 method;
    constexpr double end = 2 * std::numbers::pi;
    for (double now = 0; end - now > 1e-15;) now += method.advance(bodies, now, end - now);
    evaluations = bodies.evaluations;
    error = distance(bodies.position, start);
  }
  state.counters["evaluations"] = evaluations;
  state.counters["error"] = error;
}
BENCHMARK(once_round)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace mote::test

BENCHMARK_MAIN();
