#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mote/particles/points.hpp"
#include "mote/study/exact_field.hpp"

namespace mote {

/// The points of one layout at one resolution, as an operator sees them.
template <int D>
struct StudyPoints {
  Points<D> points;
  std::vector<bool> interior;        ///< whether a receiver lies more than the margin from any end
  std::vector<double> field;         ///< of the points' own file; empty: the study's formula holds
  std::vector<std::string> remarks;  ///< what a reader of the report should know
};

/// What study points are made from.
struct PointRequest {
  const StudyFile& study;
  const Catalogue& catalogue;
  const StudyFile::Layout& layout;
  Index resolution = 0;          ///< of no use for a file
  Index beyond = 0;              ///< cells beyond each end
  std::filesystem::path folder;  ///< that file names are relative to
};

/// Places the points of a layout, with the study's density and vorticity on them. Throws InputError
/// for a file of points that cannot be used.
template <int D>
StudyPoints<D> study_points(const PointRequest& request, const ExactField& exact);

extern template StudyPoints<1> study_points(const PointRequest&, const ExactField&);
extern template StudyPoints<2> study_points(const PointRequest&, const ExactField&);
extern template StudyPoints<3> study_points(const PointRequest&, const ExactField&);

}  // namespace mote
