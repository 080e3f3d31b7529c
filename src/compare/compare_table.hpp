#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mote/compare/comparison.hpp"
#include "mote/output/certificate.hpp"

namespace mote {

/// What came of one member.
struct Row {
  std::size_t member = 0;          ///< its place in the comparison
  std::optional<Certificate> run;  ///< none: the run left no certificate
  double updates_per_second = 0;   ///< particle updates
  bool passed = false;
  bool is_checked = false;                 ///< whether the scenario states any check
  std::vector<std::string> failed_checks;  ///< by name
  std::string problem;                     ///< why there is no certificate

  /// Whether the numerics broke down, at the time of the certificate.
  bool broke_down() const { return run && run->failure; }
  /// What kept the run from its end; empty if nothing did.
  const std::string& failure() const;
  const ErrorNorms* error(const std::string& field) const;
  /// The drift of a conserved quantity; nothing where there is none.
  std::optional<double> drift(const std::string& quantity) const;
};

/// A norm of errors with its name.
struct Norm {
  const char* name;
  double ErrorNorms::*value;
};
inline constexpr Norm norms[] = {
    {"l1", &ErrorNorms::l1}, {"l2", &ErrorNorms::l2}, {"max", &ErrorNorms::max}};
const Norm& norm_named(const std::string& name);

/// The row of a member that left `summary.json` in its folder; `problem` says how else it ended.
Row row_of(std::size_t member, const std::filesystem::path& folder, const std::string& problem);

/// Results of a comparison as far as they are there, in the order of its members.
class CompareTable {
 public:
  explicit CompareTable(const Comparison& comparison) : comparison_(&comparison) {}

  void add(Row row);

  const Comparison& comparison() const { return *comparison_; }
  const std::vector<Row>& rows() const { return rows_; }
  const Row* of(std::size_t member) const;
  /// The fields that any of the rows has errors in, and the conserved quantities.
  std::vector<std::string> fields() const;
  std::vector<std::string> quantities() const;
  /// Whether any of the runs counted how often it formed sums over pairs.
  bool counts_evaluations() const;

  /// The order in which an error falls to this row from the one before it along the key of
  /// refinement; nothing without one, or where one of the two has no error above 0.
  std::optional<double> order(const Row& row, const std::string& field, const Norm& norm) const;

 private:
  /// The next coarser member with all other values the same.
  const Row* coarser(const Row& row) const;

  const Comparison* comparison_;
  std::vector<Row> rows_;
};

/// compare.csv: the varied keys, time, particles, steps, FIELD_NORM and FIELD_NORM_order for every
/// field and norm, evaluations, wall_seconds, particle_updates_per_second, QUANTITY_drift, passed,
/// failure, folder. 17 digits; a cell without a value is empty.
std::string compare_csv(const CompareTable& table);

}  // namespace mote
