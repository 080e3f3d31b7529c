#pragma once

#include <string>
#include <vector>

#include "mote/scenario/document.hpp"
#include "mote/study/error_limits.hpp"
#include "mote/study/kepler_interpolation.hpp"

namespace mote {

/// A study file with the key `interpolation`: the errors of every path of `Paths` between exact
/// nodes on Kepler orbits. Table 2 and Figure 1 of Rehman 2014 are such a study.
struct InterpolationStudy {
  std::string name;
  std::vector<double> eccentricities;  ///< rising, in [0, 1)
  std::vector<double> sub_intervals;   ///< of a period: rising whole numbers from 3 on
  bool picture = true;

  /// What one of the errors must hold.
  struct Check {
    std::string path, quantity = "position";
    double eccentricity = 0;
    std::int64_t sub_intervals = 0;
    ErrorLimits limits;
  };
  std::vector<Check> checks;
};

/// The errors on one orbit.
struct InterpolationRow {
  int sub_intervals;
  double eccentricity;
  InterpolationErrors errors;
};

/// All of them: sub-intervals by sub-intervals the eccentricities.
using InterpolationTable = std::vector<InterpolationRow>;

bool is_interpolation_study(const Document& document);

/// Reads and checks a document. Throws LocatedError.
InterpolationStudy read_interpolation_study(const Document& document);

/// The file as YAML with every default.
std::string resolved_yaml(InterpolationStudy& study);

/// The JSON Schema of such a file.
std::string interpolation_study_schema();

/// The names of the paths, with what they are.
Choices path_choices();

InterpolationTable evaluated(const InterpolationStudy& study);

std::vector<CheckResult> table_checks(const InterpolationStudy& study,
                                      const InterpolationTable& table);

/// study.csv: sub_intervals,eccentricity,path,position,velocity, the errors in units of the
/// semi-major axis and of the circular velocity there. 17 digits.
std::string table_csv(const InterpolationTable& table);

/// The tables, one for each number of sub-intervals, in plain text and in study.md.
std::string table_text(const InterpolationTable& table);
std::string table_markdown(const InterpolationStudy& study, const InterpolationTable& table,
                           const std::vector<std::string>& pictures);

}  // namespace mote
