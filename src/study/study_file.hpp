#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mote/catalogue/entries.hpp"
#include "mote/scenario/document.hpp"
#include "mote/scenario/expression.hpp"
#include "mote/scenario/operator_choice.hpp"

namespace mote {

/// The derivatives that a study can measure.
inline const Choices study_quantities{{"gradient", "of the field"},
                                      {"laplacian", "of the field"},
                                      {"divergence", "of the vector field"},
                                      {"curl", "of the vector field"},
                                      {"hessian", "all second derivatives of the field"}};

/// The norms of errors, each relative to the same norm of the exact values.
inline const Choices study_norms{{"l1", "sum of magnitudes"},
                                 {"l2", "root of the sum of squares"},
                                 {"max", "largest magnitude"},
                                 {"interior_l1", "l1 without the cells near the ends"},
                                 {"interior_l2", "l2 without the cells near the ends"},
                                 {"interior_max", "max without the cells near the ends"}};

/// How a derivative's error is judged in words.
inline const Choices study_marks{{"good", "below the first threshold"},
                                 {"not_good", "between the thresholds"},
                                 {"bad", "above the second threshold"}};

/// One YAML file of a study, checked, with every default filled in.
struct StudyFile {
  std::string name;
  std::int64_t dimension = 0;
  std::string units = "none";
  std::vector<std::pair<std::string, double>> constants;
  std::vector<double> lower, upper;  ///< corners of the domain
  std::int64_t seed = 0;

  std::string field;
  std::vector<std::string> vector_field;  ///< one expression a dimension
  std::string density;                    ///< 1 unless stated
  bool states_density = false;            ///< whether it is the file's word, and not a default
  std::string vorticity;
  struct Derivatives {
    std::vector<std::string> gradient;  ///< of the field: x, y, z
    std::vector<std::string> hessian;   ///< of the field: xx, xy, xz, yy, yz, zz
    std::vector<std::string> jacobian;  ///< of the vector field: d a_c/d x_d, row by row
  } derivatives;

  struct Layout {
    std::string type, name;
    std::optional<std::int64_t> seed;
    std::optional<std::int64_t> margin;  ///< cells that interior norms leave out; the study's
    double jitter = 0.2;                 ///< of jittered lattices, in spacings
    std::string path;                    ///< of a file of points
  };
  std::vector<Layout> layouts;
  std::vector<double> resolutions;  ///< whole numbers: points along x

  struct Extension {
    std::string type = "formula";
    std::optional<std::int64_t> cells;  ///< beyond each end; by default the operator's reach
  } extension;

  struct Operator {
    OperatorChoice choice;
    std::string name;
    std::optional<std::int64_t> extension_cells;
  };
  std::vector<Operator> operators;

  std::vector<std::string> quantities;
  std::vector<std::string> norms{"l2", "max"};
  std::int64_t margin = 0;  ///< cells at every end that the interior norms leave out

  struct Output {
    bool points = true;
    bool picture = true;
  } output;

  /// What an error must hold, at the highest resolution.
  struct Check {
    std::string layout, differential_operator;  ///< empty: any
    std::string quantity = "gradient", norm = "l2";
    std::optional<double> error, least_order, highest_order;

    bool asks_for_order() const { return least_order || highest_order; }
  };
  std::vector<Check> checks;

  /// The marks of a table in print, and what they are compared with.
  struct Marks {
    std::string norm = "max";
    struct Threshold {
      std::string quantity = "gradient";
      double good = 0, bad = 0;
    };
    std::vector<Threshold> thresholds;
    struct Row {
      std::string differential_operator, quantity = "gradient";
      std::vector<std::string> marks;  ///< one a layout
    };
    std::vector<Row> expected;
    struct Exception {
      std::string differential_operator, layout, quantity = "gradient", because;
    };
    std::vector<Exception> exceptions;  ///< cells that cannot be reproduced
    std::int64_t least_agreement = 0;
  } marks;

  Constants constants_by_name() const { return {constants.begin(), constants.end()}; }
};

/// Says what a study file holds; the entries come from the catalogue.
void describe(Description& description, StudyFile& study, const Catalogue& catalogue);

/// Whether a document is a study and not a scenario.
bool is_study(const Document& document);

/// Reads and checks a document. Throws LocatedError.
StudyFile read_study(const Document& document, const Catalogue& catalogue);

/// The study as YAML with every default. Reading the result gives the same study.
std::string resolved_yaml(StudyFile& study, const Catalogue& catalogue);

/// The JSON Schema (2020-12) of a study file.
std::string study_schema(const Catalogue& catalogue);

}  // namespace mote
