// A vortex sheet rolled into a spiral: the velocity that each of its vortices gets from all others,
// in the time that the fast multipole method takes.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <mote/sums/biot_savart.hpp>

int main(int argc, char** argv) {
  const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 100000;

  // Positions are two numbers a vortex; all circulations together are 1.
  std::vector<double> position(2 * count), circulation(count, 1.0 / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    position[2 * i] = part * std::cos(20 * part);
    position[2 * i + 1] = part * std::sin(20 * part);
  }

  mote::BiotSavart<2> sum({.method = mote::SumMethod::multipole, .tolerance = 1e-8});
  std::vector<double> velocity(2 * count);
  const auto start = std::chrono::steady_clock::now();
  sum.at_sources({.position = position, .strength = circulation}, {.velocity = velocity});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;

  // Vortices do not push all of themselves anywhere: the circulation's own centre stays.
  double drift_x = 0, drift_y = 0, fastest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    drift_x += circulation[i] * velocity[2 * i];
    drift_y += circulation[i] * velocity[2 * i + 1];
    fastest = std::fmax(fastest, std::hypot(velocity[2 * i], velocity[2 * i + 1]));
  }
  const double drift = std::hypot(drift_x, drift_y) / fastest;
  std::printf("%zu vortices in %.3g s, the fastest at %.4f; drift of all %.1e of it\n", count,
              took.count(), fastest, drift);
  return drift < 1e-8 ? 0 : 1;
}
