#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "mote/integrators/integrator.hpp"
#include "mote/integrators/step_control.hpp"

namespace mote {

/// An explicit method that estimates its error from the stages it has, and chooses its steps by it:
/// a step whose error is beyond the tolerance is tried again, shorter. `advance_one_step` takes the
/// step it is given, whatever its error.
class EmbeddedPair : public Integrator {
 public:
  /// Throws NumericalFailure if rates of change are not finite at the start, or if no step that
  /// time can tell from none is short enough.
  double advance(System& system, double time, double longest) final;
  /// Throws NumericalFailure if rates of change are not finite.
  void advance_one_step(System& system, double time, double step) final;

  bool chooses_steps() const final { return true; }
  void tolerate(double error) final { tolerance_ = error; }

  /// The next step and the error of the last; the rates at the start of a step are formed anew.
  std::vector<double> memory() const final;
  void recall(std::span<const double> memory) final;

 protected:
  /// `power`: of the step that the estimated error goes with.
  EmbeddedPair(std::string_view name, double tolerance, int power)
      : name_(name), tolerance_(tolerance), power_(power), control_(power) {}

  /// Forms the rates at the start of a step, and says whether they are finite.
  virtual bool start(System& system, double time) = 0;

  /// Takes a step from the start and estimates its error, relative to the largest value of its
  /// kind; infinite or not a number if something is not finite. Leaves the system anywhere.
  virtual double try_step(System& system, double time, double step) = 0;

  /// Puts the system at the end of the step that was tried last.
  virtual void finish(System& system, double step) = 0;

 private:
  void start_or_fail(System& system, double time);
  [[noreturn]] void fail(double step, double error) const;

  std::string_view name_;
  double tolerance_;
  int power_;
  StepControl control_;
  double proposed_ = 0;  ///< the next step; 0 before the first
};

}  // namespace mote
