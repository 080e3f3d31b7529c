#include "mote/exact/cole_hopf_paths.hpp"

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <exception>

namespace mote {
namespace {

/// The rates of a particle in s = sqrt(t), or backwards in sqrt(end) - s.
class Rates {
 public:
  using State = std::array<double, 2>;  ///< X over a length, and ln J

  Rates(const ColeHopf& motion, double end, Direction direction)
      : motion_(motion),
        root_of_end_(std::sqrt(end)),
        length_(motion.length()),
        backwards_(direction == Direction::backwards) {}

  double root_of_end() const { return root_of_end_; }

  void operator()(const State& state, State& rate, double way) const {
    const double place = state[0] * length_;
    const auto [velocity, stretching] =
        backwards_ ? forward(place, root_of_end_ - way) : forward(place, way);
    const double direction = backwards_ ? -1 : 1;
    rate = {direction * velocity / length_, direction * stretching};
  }

 private:
  State forward(double place, double root) const {
    const double first = 1e-8 * root_of_end_;
    if (root >= first) {
      const auto [velocity, slope] = motion_(place, root * root);
      return {2 * root * velocity, 2 * root * slope};
    }
    // At a jump 2 s u_x has a limit at s = 0; elsewhere this is 0 as it must be.
    const double once = forward(place, first)[1], twice = forward(place, 2 * first)[1];
    return {2 * root * motion_(place, first * first).velocity, 2 * once - twice};
  }

  const ColeHopf& motion_;
  double root_of_end_, length_;
  bool backwards_;
};

FluidParticle followed(const ColeHopf& motion, double position, double time, Direction direction) {
  namespace odeint = boost::numeric::odeint;
  constexpr double error = 1e-14;
  const Rates rates(motion, time, direction);
  const double length = motion.length(), way = rates.root_of_end();
  Rates::State state{position / length, 0};
  odeint::integrate_adaptive(odeint::bulirsch_stoer<Rates::State>(error, error), rates, state, 0.0,
                             way, 0.01 * way);
  return {state[0] * length, state[1]};
}

}  // namespace

std::vector<FluidParticle> followed(const ColeHopf& motion, std::span<const double> positions,
                                    double time, Direction direction) {
  std::vector<FluidParticle> particles(positions.size());
  std::vector<std::exception_ptr> failures(positions.size());
  // A path is long enough to be worth a thread however few there are.
#pragma omp parallel for schedule(dynamic)
  for (std::size_t i = 0; i < positions.size(); ++i) {
    try {
      particles[i] = followed(motion, positions[i], time, direction);
    } catch (...) {
      failures[i] = std::current_exception();
    }
  }
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
  return particles;
}

}  // namespace mote
