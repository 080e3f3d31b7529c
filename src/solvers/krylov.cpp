#include "mote/solvers/krylov.hpp"

namespace mote {

using Eigen::VectorXd;

void conjugate_gradients(const PreconditionedSystem& system, VectorXd& residual, VectorXd& solution,
                         Convergence& convergence) {
  VectorXd correction, direction, product;
  system.precondition(residual, correction);
  direction = correction;
  double size = residual.dot(correction);
  while (convergence.may_go_on()) {
    system.multiply(direction, product);
    const double curvature = direction.dot(product);
    if (!(size > 0 && curvature > 0)) return;
    const double step = size / curvature;
    solution += step * direction;
    residual -= step * product;
    convergence.record(residual.norm());
    if (!convergence.may_go_on()) return;
    system.precondition(residual, correction);
    const double next_size = residual.dot(correction);
    direction = correction + (next_size / size) * direction;
    size = next_size;
  }
}

/// Names of van der Vorst's: rho, alpha, omega, p, v, s, t; y and z are p and s preconditioned.
void bicgstab(const PreconditionedSystem& system, VectorXd& residual, VectorXd& solution,
              Convergence& convergence) {
  const VectorXd shadow = residual;
  VectorXd p = residual, v, y, z, t;
  double rho = shadow.dot(residual);
  while (convergence.may_go_on()) {
    system.precondition(p, y);
    system.multiply(y, v);
    const double shadow_v = shadow.dot(v);
    if (rho == 0 || shadow_v == 0) return;
    const double alpha = rho / shadow_v;
    solution += alpha * y;
    residual -= alpha * v;  // s
    system.precondition(residual, z);
    system.multiply(z, t);
    const double t_squared = t.squaredNorm();
    const double omega = t_squared > 0 ? t.dot(residual) / t_squared : 0;
    solution += omega * z;
    residual -= omega * t;
    convergence.record(residual.norm());
    if (omega == 0) return;
    const double next_rho = shadow.dot(residual);
    p = residual + (next_rho / rho) * (alpha / omega) * (p - omega * v);
    rho = next_rho;
  }
}

}  // namespace mote
