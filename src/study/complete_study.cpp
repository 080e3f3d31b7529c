#include "mote/study/complete_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mote/particles/lattice.hpp"
#include "mote/scenario/folder_name.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/suggestion.hpp"
#include "mote/scenario/symbolic.hpp"

namespace mote {
namespace {

/// Checks what no single key can state, and fills in the defaults that depend on several.
class Completion {
 public:
  Completion(StudyFile& study, const Document& document)
      : study_(study), document_(document), dimension_(static_cast<std::size_t>(study.dimension)) {}

  void complete() {
    require(folder_name_problem(study_.name).empty(), "name", folder_name_problem(study_.name));
    check_domain();
    check_resolutions();
    check_margin();
    check_files();
    for (std::size_t k = 0; k < study_.operators.size(); ++k) complete_operator(k);
    complete_layouts();
    complete_names(study_.layouts, "layouts", "layout");
    complete_names(study_.operators, "operators", "operator");
    complete_quantities();
    complete_fields();
    check_checks();
    check_marks();
  }

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const {
    throw LocatedError(document_.locate(key), message);
  }
  void require(bool holds, const std::string& key, const std::string& message) const {
    if (!holds) refuse(key, message);
  }

  bool only_files() const {
    return std::ranges::all_of(study_.layouts,
                               [](const auto& layout) { return layout.type == "file"; });
  }

  void check_domain() const {
    if (only_files()) return;
    require(document_.root().find("domain") != nullptr, "", "the study lacks the key 'domain'");
    for (const char* corner : {"lower", "upper"}) {
      const auto& values = corner[0] == 'l' ? study_.lower : study_.upper;
      require(values.size() == dimension_, std::string("domain.") + corner,
              fmt::format("'{}' needs {} number{}, one a dimension, and has {}", corner, dimension_,
                          dimension_ == 1 ? "" : "s", values.size()));
    }
    for (std::size_t d = 0; d < dimension_; ++d)
      require(study_.upper[d] > study_.lower[d] && std::isfinite(study_.upper[d] - study_.lower[d]),
              "domain.upper",
              fmt::format("the upper corner {} must lie above the lower {}", study_.upper[d],
                          study_.lower[d]));
  }

  void check_resolutions() const {
    require(only_files() || !study_.resolutions.empty(), "resolutions",
            "the study lacks the key 'resolutions', the numbers of points along x");
    double before = 1;
    for (const double count : study_.resolutions) {
      require(count == std::floor(count) && count >= 2 && count <= 1e8, "resolutions",
              fmt::format("a resolution is a whole number from 2 to 1e8, and not {}", count));
      require(count > before, "resolutions", "the resolutions must rise");
      before = count;
    }
  }

  /// Interior norms need ends, and a margin needs interior norms.
  void check_margin() const {
    const bool has_interior = std::ranges::any_of(
        study_.norms, [](const std::string& norm) { return norm.starts_with("interior_"); });
    for (const auto& layout : study_.layouts) {
      require(!has_interior || layout.type != "file", "norms",
              "the ends of a file of points are not known");
      require(has_interior || (layout.margin.value_or(study_.margin) == 0), "margin",
              "a margin has a meaning for interior norms alone, and 'norms' has none");
    }
  }

  /// What files of points cannot use must not be there for them alone.
  void check_files() const {
    if (!only_files()) return;
    for (const char* key : {"resolutions", "extension", "domain"})
      require(document_.root().find(key) == nullptr, key,
              fmt::format("'{}' has no meaning where all layouts are files of points", key));
  }

  void complete_operator(std::size_t k) {
    auto& item = study_.operators[k];
    require(item.choice.made != nullptr, fmt::format("operators.{}", k),
            fmt::format("the operator {} does not exist in {} dimensions", item.choice.name(),
                        study_.dimension));
    require(!item.extension_cells || study_.extension.type != "none",
            fmt::format("operators.{}", k),
            "'extension_cells' has no meaning with 'extension: none'");
    if (item.name.empty()) item.name = item.choice.name();
  }

  void complete_layouts() {
    for (std::size_t k = 0; k < study_.layouts.size(); ++k) {
      auto& layout = study_.layouts[k];
      const bool everywhere = layout.type == "file" ||
                              std::ranges::find(lattice_layouts(), layout.type, &Choice::name) !=
                                  lattice_layouts().end();
      require(everywhere || dimension_ == 1, fmt::format("layouts.{}", k),
              fmt::format("'{}' is a mesh of a line; in {} dimensions there are lattice, jittered "
                          "and file",
                          layout.type, dimension_));
      if (!layout.seed && (layout.type == "jittered" || layout.type == "random"))
        layout.seed = study_.seed;
      if (layout.name.empty())
        layout.name = layout.type == "file" ? std::filesystem::path(layout.path).stem().string()
                                            : layout.type;
    }
  }

  template <class Items>
  void complete_names(const Items& items, const std::string& key, const std::string& what) const {
    for (auto item = items.begin(); item != items.end(); ++item) {
      const std::string place = fmt::format("{}.{}", key, item - items.begin());
      require(std::none_of(items.begin(), item,
                           [&](const auto& other) { return other.name == item->name; }),
              place,
              fmt::format("two {}s are called '{}'; give one of them another 'name'", what,
                          item->name));
      require(item->name.find_first_of(",\"\n\r|") == std::string::npos, place,
              fmt::format("the name '{}' cannot stand in a table", item->name));
    }
  }

  void complete_quantities() {
    if (study_.quantities.empty()) {
      study_.quantities = {"gradient", "laplacian"};
      if (dimension_ > 1)
        study_.quantities = {"gradient", "divergence", "curl", "hessian", "laplacian"};
    }
    for (auto* list : {&study_.quantities, &study_.norms})
      for (auto word = list->begin(); word != list->end(); ++word)
        require(std::find(list->begin(), word, *word) == word,
                list == &study_.norms ? "norms" : "quantities",
                fmt::format("'{}' is named twice", *word));
    require(
        dimension_ > 1 || std::ranges::find(study_.quantities, "curl") == study_.quantities.end(),
        "quantities", "a line has no curl");
  }

  /// A study has no time, and only as many coordinates as dimensions.
  void check_names(const std::string& formula, const std::string& key) const {
    const Expression expression(formula, study_.constants_by_name());
    require(!expression.uses("t"), key, fmt::format("'{}' depends on t, a study has no time", key));
    for (std::size_t d = dimension_; d < 3; ++d) {
      const std::string axis(1, "xyz"[d]);
      require(!expression.uses(axis), key,
              fmt::format("'{}' depends on {}, which {} dimension{} not have", key, axis,
                          dimension_, dimension_ == 1 ? " does" : "s do"));
    }
  }

  void complete_fields() {
    check_names(study_.field, "field");
    if (!study_.density.empty()) check_names(study_.density, "density");
    if (!study_.vorticity.empty()) check_names(study_.vorticity, "vorticity");
    for (const std::string& component : study_.vector_field) check_names(component, "vector_field");
    if (study_.vector_field.empty()) study_.vector_field.assign(dimension_, study_.field);
    require(study_.vector_field.size() == dimension_, "vector_field",
            fmt::format("'vector_field' needs {} expressions, one a dimension, and has {}",
                        dimension_, study_.vector_field.size()));
    study_.states_density = !study_.density.empty();
    if (!study_.states_density) study_.density = "1";
    if (study_.vorticity.empty()) study_.vorticity = study_.density;
    auto& derivatives = study_.derivatives;
    complete_gradient(study_.field, derivatives.gradient);
    check_count(derivatives.gradient, dimension_, "gradient");
    complete_hessian(derivatives.hessian);
    if (derivatives.jacobian.empty() && needs_jacobian())
      for (const std::string& component : study_.vector_field)
        for (std::size_t d = 0; d < dimension_; ++d)
          derivatives.jacobian.push_back(derivative(component, d, "vector_field", "jacobian"));
    check_count(derivatives.hessian, dimension_ * (dimension_ + 1) / 2, "hessian");
    if (!derivatives.jacobian.empty())
      check_count(derivatives.jacobian, dimension_ * dimension_, "jacobian");
  }

  bool needs_jacobian() const {
    return std::ranges::any_of(study_.quantities, [](const std::string& quantity) {
      return quantity == "divergence" || quantity == "curl";
    });
  }

  void complete_gradient(const std::string& formula, std::vector<std::string>& gradient) const {
    if (!gradient.empty()) return;
    for (std::size_t d = 0; d < dimension_; ++d)
      gradient.push_back(derivative(formula, d, "field", "gradient"));
  }

  void complete_hessian(std::vector<std::string>& hessian) const {
    if (!hessian.empty()) return;
    for (std::size_t c = 0; c < dimension_; ++c)
      for (std::size_t d = c; d < dimension_; ++d)
        hessian.push_back(derivative(
            study_.derivatives.gradient[c], d,
            document_.root().find("derivatives") != nullptr ? "derivatives.gradient" : "field",
            "hessian"));
  }

  std::string derivative(const std::string& formula, std::size_t d, const std::string& key,
                         const std::string& wanted) const {
    try {
      return derivative_of(formula, "xyz"[d], study_.constants_by_name());
    } catch (const ExpressionError& error) {
      refuse(key, fmt::format("{}; give '{}' in the section 'derivatives'", error.what(), wanted));
    }
  }

  void check_count(const std::vector<std::string>& formulas, std::size_t needed,
                   const std::string& key) const {
    require(formulas.size() == needed, "derivatives." + key,
            fmt::format("'{}' needs {} expressions, and has {}", key, needed, formulas.size()));
  }

  template <class Items>
  void check_name(const Items& items, const std::string& name, const std::string& key,
                  const std::string& what) const {
    std::vector<std::string> names;
    for (const auto& item : items) names.push_back(item.name);
    if (name.empty() || std::ranges::find(names, name) != names.end()) return;
    refuse(key, fmt::format("there is no {} '{}'{}", what, name, suggestion(name, names)));
  }

  void check_cell(const std::string& layout, const std::string& differential_operator,
                  const std::string& quantity, const std::string& key) const {
    check_name(study_.layouts, layout, key, "layout");
    check_name(study_.operators, differential_operator, key, "operator");
    require(std::ranges::find(study_.quantities, quantity) != study_.quantities.end(), key,
            fmt::format("the study does not measure the {}", quantity));
  }

  void check_norm(const std::string& norm, const std::string& key) const {
    require(std::ranges::find(study_.norms, norm) != study_.norms.end(), key,
            fmt::format("the study does not measure the norm {}", norm));
  }

  void check_checks() const {
    for (std::size_t k = 0; k < study_.checks.size(); ++k) {
      const auto& check = study_.checks[k];
      const std::string key = fmt::format("check.{}", k);
      check_cell(check.layout, check.differential_operator, check.quantity, key);
      check_norm(check.norm, key);
      require(check.error || check.asks_for_order(), key,
              "a check needs 'error', 'least_order' or 'highest_order'");
      require(!check.asks_for_order() || study_.resolutions.size() > 1, key,
              "an order needs two resolutions");
      require(
          !check.least_order || !check.highest_order || *check.least_order <= *check.highest_order,
          key, "'least_order' must not lie above 'highest_order'");
      const auto named = std::ranges::find(study_.layouts, check.layout, &StudyFile::Layout::name);
      require(!check.asks_for_order() || named == study_.layouts.end() || named->type != "file",
              key, "a file of points has one resolution, and so no order");
    }
  }

  void check_marks() const {
    const auto& marks = study_.marks;
    if (!marks.thresholds.empty()) check_norm(marks.norm, "marks.norm");
    for (auto threshold = marks.thresholds.begin(); threshold != marks.thresholds.end();
         ++threshold) {
      const auto key = fmt::format("marks.thresholds.{}", threshold - marks.thresholds.begin());
      require(threshold->bad >= threshold->good, key,
              "the threshold 'bad' must not lie below 'good'");
      require(std::none_of(marks.thresholds.begin(), threshold,
                           [&](const auto& t) { return t.quantity == threshold->quantity; }),
              key, fmt::format("the {} has its thresholds already", threshold->quantity));
    }
    for (std::size_t k = 0; k < marks.expected.size(); ++k)
      check_row(marks.expected[k], fmt::format("marks.expected.{}", k));
    for (std::size_t k = 0; k < marks.exceptions.size(); ++k) {
      const auto& cell = marks.exceptions[k];
      check_cell(cell.layout, cell.differential_operator, cell.quantity,
                 fmt::format("marks.exceptions.{}", k));
    }
    const std::size_t cells = marks.expected.size() * study_.layouts.size();
    require(marks.least_agreement <= static_cast<std::int64_t>(cells), "marks.least_agreement",
            fmt::format("there are only {} marks", cells));
  }

  void check_row(const StudyFile::Marks::Row& row, const std::string& key) const {
    check_cell("", row.differential_operator, row.quantity, key);
    require(row.marks.size() == study_.layouts.size(), key,
            fmt::format("'marks' needs one word for each of the {} layouts, and has {}",
                        study_.layouts.size(), row.marks.size()));
    require(
        std::ranges::find(study_.marks.thresholds, row.quantity,
                          &StudyFile::Marks::Threshold::quantity) != study_.marks.thresholds.end(),
        key, fmt::format("there are no thresholds for the {}", row.quantity));
  }

  StudyFile& study_;
  const Document& document_;
  std::size_t dimension_;
};

}  // namespace

void complete(StudyFile& study, const Document& document) {
  Completion(study, document).complete();
}

}  // namespace mote
