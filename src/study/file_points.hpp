#pragma once

#include "mote/study/study_points.hpp"

namespace mote {

/// Anybody's points from a file with the columns x[,y[,z]][,volume][,mass][,density][,field]. What
/// is not there follows from the rest: the volume from mass and density, or else from how closely
/// the points lie (1 over the sum of a kernel as wide as twice the distance of the 2 D nearest);
/// the density from mass and volume, or else from the study's formula, which for points with mass
/// alone counts only if the study states it. Throws InputError for a file that cannot be used,
/// naming the first offending point.
template <int D>
StudyPoints<D> file_points(const PointRequest& request, const ExactField& exact);

}  // namespace mote
