#include <gtest/gtest.h>
#include <omp.h>

#include <functional>
#include <memory>

#include "counted_memory.hpp"
#include "mote/integrators/all.hpp"
#include "mote/particles/failure.hpp"
#include "support/line_gas.hpp"
#include "support/operators_on_a_line.hpp"

namespace mote::test {
namespace {

/// Every way to run the gas that makes it use its operator, as far as the options go together.
std::vector<PressurelessGasOptions> ways_to_run() {
  std::vector<PressurelessGasOptions> ways;
  for (const GravityForm form : {GravityForm::sheets, GravityForm::potential})
    for (const FrameChoice frame : {FrameChoice::lagrangian, FrameChoice::eulerian})
      for (const DensityForm density : {DensityForm::mass_over_volume, DensityForm::continuity})
        for (const double viscosity : {0.0, 1e-3})
          if (frame == FrameChoice::lagrangian || density == DensityForm::continuity)
            ways.push_back({.gravity = 0.0015,
                            .viscosity = viscosity,
                            .gravity_form = form,
                            .density = density,
                            .frame = frame,
                            .viscosity_scheme = ViscosityScheme::explicit_rates});
  return ways;
}

/// Takes one step, and asks whether the model can go on from there.
bool step_holds(PressurelessGas& model, Integrator& integrator, int k) {
  constexpr double step = 0.0025;
  try {
    step_once(model, integrator, k * step, step);
    const long before = allocations();
    model.inspect();
    EXPECT_EQ(allocations(), before);
  } catch (const NumericalFailure&) {
    return false;
  }
  return true;
}

/// Memory that 200 steps after the first ask for, or as many as the particles do not cross in. The
/// flow brings particles together in places, so that lists of neighbours change and grow. None if
/// the integrator needs what this gas lacks.
long allocations_after_first_step(const PressurelessGasOptions& options, OperatorOnALine op,
                                  Integrator& integrator) {
  LineGas gas = trapezoid();
  gas.velocity = [](double x) { return 0.2 * std::sin(2 * x); };
  PressurelessGas model = make_gas(gas, options, 41, std::move(op));
  if (!integrator.missing_in(model).empty()) return 0;
  EXPECT_TRUE(step_holds(model, integrator, 0));
  const long before = allocations();
  for (int k = 1; k <= 200; ++k) {
    const long so_far = allocations() - before;
    if (!step_holds(model, integrator, k)) return so_far;
  }
  return allocations() - before;
}

/// The operators that the gas can use: it has no circulation for vortex blobs.
std::vector<NamedOperator> operators_of_a_gas() {
  std::vector<NamedOperator> operators = operators_on_a_line();
  std::erase_if(operators, [](const auto& op) { return op.name.starts_with("vortex_blob"); });
  return operators;
}

TEST(VortexBlob, IsRefusedByAGasWithoutCirculation) {
  const PressurelessGasOptions options{.viscosity = 1e-3};
  SymplecticEuler integrator;
  EXPECT_THROW(allocations_after_first_step(options, std::make_unique<VortexBlob<1, Gauss<1>>>(),
                                            integrator),
               InputError);
}

struct RightHandSide : testing::TestWithParam<NamedOperator> {};

/// Nothing that these integrators ask for after the first step, in any way to run the gas.
template <class List>
void expect_no_allocations(List integrators, const std::function<OperatorOnALine()>& make) {
  omp_set_num_threads(2);
  for (const auto& options : ways_to_run())
    for_each_type(integrators, [&]<class Method>() {
      Method method;
      EXPECT_EQ(allocations_after_first_step(options, make(), method), 0)
          << Method::name << ", viscosity " << options.viscosity << ", frame "
          << static_cast<int>(options.frame) << ", density " << static_cast<int>(options.density)
          << ", gravity_form " << static_cast<int>(options.gravity_form);
    });
}

TEST_P(RightHandSide, AllocatesNothingAfterTheFirstStep) {
  expect_no_allocations(TypeList<SymplecticEuler, VelocityVerlet, RungeKutta4>{}, GetParam().make);
}

TEST(EveryIntegrator, AllocatesNothingAfterTheFirstStep) {
  expect_no_allocations(Integrators{}, sph_gauss);
}

INSTANTIATE_TEST_SUITE_P(, RightHandSide, testing::ValuesIn(operators_of_a_gas()),
                         [](const auto& op) { return op.param.name; });

TEST(AllocationCount, NoticesEveryKindOfNew) {
  const long before = allocations();
  const auto one = std::make_unique<double>(1);
  const auto many = std::make_unique<double[]>(10);
  const std::vector<Vec<2>> vectors(5);
  struct alignas(64) Line {
    double values[8];
  };
  const auto line = std::make_unique<Line>();
  EXPECT_EQ(allocations() - before, 4);
}

/// A method that keeps no work arrays.
struct WastefulEuler : Integrator {
  void advance_one_step(System& system, double time, double step) override {
    const auto copy = std::make_unique<SymplecticEuler>();
    copy->advance_one_step(system, time, step);
  }
};

TEST(AllocationCount, RejectsAMethodThatAllocatesEveryStep) {
  WastefulEuler wasteful;
  EXPECT_GE(allocations_after_first_step({.gravity = 0.0015}, sph_gauss(), wasteful), 200);
}

}  // namespace
}  // namespace mote::test
