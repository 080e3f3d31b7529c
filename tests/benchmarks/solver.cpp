// Cost of the pressure Poisson equation with the weights of MPS on a jittered lattice, top layer
// held, to a relative residual of 1e-8 from zero, on one core: set-up and solve, and iterations.
// Run by hand on a quiet machine: benchmark_solver --benchmark_filter=2D

#include <benchmark/benchmark.h>
#include <omp.h>

#include <string>

#include "mote/solvers/linear_solver.hpp"
#include "support/poisson.hpp"

namespace mote::test {
namespace {

template <int D>
void solve(benchmark::State& state, const std::string& name, const PoissonShape& shape) {
  omp_set_num_threads(1);
  const SparseMatrix matrix = poisson_matrix<D>(shape);
  const auto b = rough_and_smooth(static_cast<Index>(matrix.rows()));
  const auto solver = make_linear_solver(name, {});
  SolveResult result;
  double setup = 0, iterate = 0;
  for (auto _ : state) {
    std::vector<double> x(b.size());
    result = solver->solve(matrix, b, x);
    setup += result.setup_seconds;
    iterate += result.solve_seconds;
  }
  const auto mean = benchmark::Counter::kAvgIterations;
  state.counters["setup_s"] = {setup, mean};
  state.counters["solve_s"] = {iterate, mean};
  state.counters["iterations"] = result.iterations;
  state.counters["unknowns"] = static_cast<double>(matrix.rows());
  state.counters["entries_a_row"] =
      static_cast<double>(matrix.nonZeros()) / static_cast<double>(matrix.rows());
}

template <int D>
void add(const std::string& name, Index side) {
  for (const double left_out : {0.0, 0.2}) {
    const auto full = std::to_string(D) + "D/" + name + "/side:" + std::to_string(side) +
                      (left_out > 0 ? "/left_out" : "/whole");
    benchmark::RegisterBenchmark(
        full.c_str(),
        [=](auto& state) { solve<D>(state, name, {.side = side, .left_out = left_out}); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MinTime(0.3);
  }
}

}  // namespace
}  // namespace mote::test

int main(int argc, char** argv) {
  for (const auto& solver : mote::solver_names()) {
    for (const mote::Index side : {100, 316, 1000}) mote::test::add<2>(solver.name, side);
    mote::test::add<3>(solver.name, 46);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
