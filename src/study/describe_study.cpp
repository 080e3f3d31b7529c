#include "mote/particles/lattice.hpp"
#include "mote/study/study_file.hpp"

namespace mote {
namespace {

Choices layouts_in(const Catalogue& catalogue) {
  Choices choices = choices_of(catalogue.layouts);
  for (const Choice& lattice : lattice_layouts()) choices.push_back(lattice);
  choices.push_back({"file", "anybody's points: CSV, VTK or HDF5"});
  return choices;
}

void describe_layout(Description& d, StudyFile::Layout& layout, const Catalogue& catalogue) {
  d.variant({"type", "how the points lie", true}, layout.type, layouts_in(catalogue),
            [&](const std::string& type) {
              layout.type = type;
              if (type == "file")
                d.text({"path", "the file, beside the study's own", true}, layout.path);
              if (type == "jittered")
                d.number({"jitter", "largest move in each direction, in spacings"}, layout.jitter,
                         {0, 0.5});
              if (type == "jittered" || type == "random")
                d.count({"seed", "of the random numbers; default: the study's"}, layout.seed,
                        not_negative);
            });
  d.text({"name", "in the tables; default: its type, or the file's name"}, layout.name);
  d.count({"margin", "cells at every end that interior norms leave out; default: the study's"},
          layout.margin, not_negative);
}

void describe_derivatives(Description& d, StudyFile::Derivatives& derivatives) {
  d.expressions({"gradient", "of the field: x, y, z"}, derivatives.gradient);
  d.expressions({"hessian", "of the field: xx, xy, xz, yy, yz, zz"}, derivatives.hessian);
  d.expressions({"jacobian", "of the vector field: its derivatives along x, y, z, row by row"},
                derivatives.jacobian);
}

void describe_extension(Description& d, StudyFile::Extension& extension) {
  d.variant({"type", "how the points go on beyond the domain"}, extension.type,
            {{"none", "they do not: the ends are free"},
             {"formula", "by the layout's own formula"},
             {"constant", "with cells like the end cell"},
             {"mirror", "as in a mirror at the end"},
             {"periodic", "with the points of the other end"}},
            [&](const std::string& type) {
              if (type != "none")
                d.count({"cells", "beyond each end (N_end_cor); default: the operator's reach"},
                        extension.cells, {0, 1e6});
            });
}

void describe_operator_item(Description& d, StudyFile::Operator& item, const Catalogue& catalogue,
                            std::int64_t dimension) {
  describe_operator(d, item.choice, catalogue, dimension);
  d.text({"name", "in the tables; default: as in sph.gauss"}, item.name);
  d.count({"extension_cells", "cells beyond each end, for this operator"}, item.extension_cells,
          {0, 1e6});
}

void describe_output(Description& d, StudyFile::Output& output) {
  d.flag({"points", "whether to write points.csv"}, output.points);
  d.flag({"picture", "whether to draw pictures at the end"}, output.picture);
}

void describe_check(Description& d, StudyFile::Check& check) {
  d.text({"layout", "name of a layout; default: each"}, check.layout);
  d.text({"operator", "name of an operator; default: each"}, check.differential_operator);
  d.choice({"quantity", "which derivative"}, check.quantity, study_quantities);
  d.choice({"norm", "of the error"}, check.norm, study_norms);
  d.number({"error", "largest error at the highest resolution"}, check.error, positive);
  d.number({"least_order", "of the error between the two highest resolutions"}, check.least_order);
  d.number({"highest_order", "of the same"}, check.highest_order);
}

void describe_marks(Description& d, StudyFile::Marks& marks) {
  d.choice({"norm", "of the errors that are judged"}, marks.norm, study_norms);
  describe_list(d, {"thresholds", "of the errors, a quantity each"}, marks.thresholds,
                [&](auto& threshold) {
                  d.choice({"quantity", "which derivative"}, threshold.quantity, study_quantities);
                  d.number({"good", "errors below this are good", true}, threshold.good, positive);
                  d.number({"bad", "errors above this are bad", true}, threshold.bad, positive);
                });
  describe_list(d, {"expected", "the marks in print, a row each"}, marks.expected, [&](auto& row) {
    d.text({"operator", "name of the operator", true}, row.differential_operator);
    d.choice({"quantity", "which derivative"}, row.quantity, study_quantities);
    d.words({"marks", "one for each layout, in their order", true}, row.marks, study_marks);
  });
  describe_list(d, {"exceptions", "cells that cannot be reproduced"}, marks.exceptions,
                [&](auto& cell) {
                  d.text({"operator", "name of the operator", true}, cell.differential_operator);
                  d.text({"layout", "name of the layout", true}, cell.layout);
                  d.choice({"quantity", "which derivative"}, cell.quantity, study_quantities);
                  d.text({"because", "why not", true}, cell.because);
                });
  d.count({"least_agreement", "marks that must agree"}, marks.least_agreement, not_negative);
}

}  // namespace

void describe(Description& d, StudyFile& study, const Catalogue& catalogue) {
  d.text({"name", "names the output folder and the report", true}, study.name);
  d.count({"dimension", "number of space dimensions", true}, study.dimension, {1, 3});
  d.choice({"units", "what the numbers mean"}, study.units,
           {{"none", "the user's own units"}, {"SI", "metres, kilograms, seconds"}});
  d.constants({"constants", "numbers that all expressions may name"}, study.constants);
  d.section({"domain", "where the points are; not needed for files of points"}, [&] {
    d.numbers({"lower", "lower corner, one number a dimension"}, study.lower);
    d.numbers({"upper", "upper corner, one number a dimension"}, study.upper);
  });
  d.count({"seed", "of all random numbers"}, study.seed, not_negative);
  d.expression({"field", "whose derivatives are formed", true}, study.field);
  d.expressions({"vector_field", "for divergence and curl; default: the field in each component"},
                study.vector_field);
  d.expression({"density", "of the points; default: 1"}, study.density);
  d.expression({"vorticity", "of the points, for vortex_blob; default: the density"},
               study.vorticity);
  d.section({"derivatives", "exact ones; default: found by symbolic differentiation"},
            [&] { describe_derivatives(d, study.derivatives); });
  describe_list(d, {"layouts", "how the points lie", true}, study.layouts,
                [&](auto& layout) { describe_layout(d, layout, catalogue); });
  d.numbers({"resolutions", "points along x, the fewest first"}, study.resolutions);
  d.section({"extension", "what lies beyond the domain"},
            [&] { describe_extension(d, study.extension); });
  describe_list(d, {"operators", "how derivatives are formed", true}, study.operators,
                [&](auto& item) { describe_operator_item(d, item, catalogue, study.dimension); });
  d.words({"quantities", "which derivatives; default: all that the dimension has"},
          study.quantities, study_quantities);
  d.words({"norms", "of the errors"}, study.norms, study_norms);
  d.count({"margin", "cells at every end that the interior norms leave out"}, study.margin,
          not_negative);
  d.section({"output", "what is written"}, [&] { describe_output(d, study.output); });
  describe_list(d, {"check", "what the errors must hold"}, study.checks,
                [&](auto& check) { describe_check(d, check); });
  d.section({"marks", "errors in words, against a table in print"},
            [&] { describe_marks(d, study.marks); });
}

}  // namespace mote
