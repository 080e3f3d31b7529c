#pragma once

#include "mote/sums/cauchy.hpp"

namespace mote {

/// The most terms of a power series: what a ratio of 0.95 or so needs for a tolerance of 1e-8.
/// Beyond, pair by pair is as fast for thousands of points, and the multipole method for any
/// number.
inline constexpr int most_series_terms = 500;

/// c_i = sum_j v_j/(s_i - t_j) for sources t and targets s that a circle parts, by one power series
/// in t/s, (11), or in s/t, (12), of Tabanjeh (2014), section 7, with the sums over sources and
/// over terms exchanged; O((N + M) terms). The series stands about the origin, as printed, or about
/// the middle of the sources or of the targets, wherever the ratio of the radii is least: s - t
/// does not notice a shift.
///
/// With rho = r/R the ratio of the largest inner and the least outer radius, what M + 1 terms leave
/// out is at most sum_j |v_j| rho^(M+1)/(R - r) at any target, by the rest of the geometric series.
/// M is the least for which that is at most `tolerance` times the largest |c_i| of a few targets,
/// which are summed pair by pair. Throws InputError where that takes more than most_series_terms.
/// Results do not depend on the number of threads.
void power_series(std::span<const Complex> targets, std::span<const Complex> sources,
                  std::span<const Complex> strengths, double tolerance, std::span<Complex> result);

}  // namespace mote
