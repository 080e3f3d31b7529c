#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "mote/study/marks.hpp"
#include "mote/study/run_study.hpp"

namespace mote {

/// study.csv: layout,resolution,operator,quantity,norm,error,order; no order at the first
/// resolution.
std::string study_csv(const StudyResult& result);

/// study.md, the study for a person: verdict, errors and orders, marks, remarks, pictures.
std::string study_markdown(const StudyFile& study, const StudyResult& result,
                           const std::vector<std::string>& pictures);

/// Writes the large tables case by case, under temporary names until `finish`:
/// points.csv: layout,resolution,operator,index,x[,y,z],field, then for every quantity and
/// component NAME_computed,NAME_exact, where NAME is such as gradient_x, hessian_xy or laplacian;
/// check_up.csv, if there are points of a user's own: layout,operator,index,x[,y,z],neighbours,
/// covered,condition. 17 digits.
class CaseTables {
 public:
  CaseTables(const std::filesystem::path& folder, bool with_points);
  void add(const StudyCase& done);
  void finish();

  bool has_check_up() const { return check_up_.file.is_open(); }

  /// Removes what is unfinished but for a check-up, which is finished; whether there is one.
  bool keep_check_up();

 private:
  struct Table {
    std::filesystem::path path;
    std::ofstream file;
  };
  void add_points(const StudyCase& done);
  void add_neighbourhoods(const StudyCase& done);
  static void finish(Table& table);
  static void write(Table& table, const std::string& header, const std::string& rows);

  Table points_, check_up_;
  bool with_points_;
};

}  // namespace mote
