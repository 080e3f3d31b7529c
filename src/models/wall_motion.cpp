#include "mote/models/wall_motion.hpp"

namespace mote {

void observe(const std::vector<Body>& bodies, double time, double half,
             std::vector<WallMotion>& motions) {
  motions.assign(bodies.size(), {});
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const auto& velocity = bodies[k].velocity;
    if (!velocity) continue;
    motions[k].velocity = velocity(time);
    const Triple before = velocity(time - half), after = velocity(time + half);
    for (std::size_t d = 0; d < before.size(); ++d)
      motions[k].acceleration[d] = (after[d] - before[d]) / (2 * half);
  }
}

}  // namespace mote
