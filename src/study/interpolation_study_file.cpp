#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mote/catalogue/entries.hpp"
#include "mote/integrators/paths.hpp"
#include "mote/scenario/folder_name.hpp"
#include "mote/scenario/located_error.hpp"
#include "mote/scenario/reader.hpp"
#include "mote/scenario/schema.hpp"
#include "mote/scenario/writer.hpp"
#include "mote/study/interpolation_study.hpp"

namespace mote {
namespace {

void describe_check(Description& d, InterpolationStudy::Check& check) {
  d.choice({"path", "by which polynomial", true}, check.path, path_choices());
  d.number({"eccentricity", "one of the study's", true}, check.eccentricity);
  d.count({"sub_intervals", "one of the study's numbers of them", true}, check.sub_intervals);
  d.choice({"quantity", "the error of which"}, check.quantity,
           {{"position", "in semi-major axes"}, {"velocity", "in circular velocities"}});
  check.limits.describe(d);
}

void describe(Description& d, InterpolationStudy& study) {
  d.text({"name", "names the output folder and the report", true}, study.name);
  d.section({"interpolation", "of the Kepler problem over a period, by every path", true}, [&] {
    d.numbers({"eccentricities", "of the orbits, from 0 to below 1, rising", true},
              study.eccentricities);
    d.numbers({"sub_intervals", "equal parts of the period, at least 3, rising", true},
              study.sub_intervals);
  });
  d.section({"output", "what is written"}, [&] {
    d.flag({"picture", "whether to draw errors.png"}, study.picture);
  });
  describe_list(d, {"check", "what the errors must hold"}, study.checks,
                [&](auto& check) { describe_check(d, check); });
}

/// Rules that no single key can state.
class Checker {
 public:
  Checker(const InterpolationStudy& study, const Document& document)
      : study_(study), document_(document) {}

  void check() const {
    require(folder_name_problem(study_.name).empty(), "name", folder_name_problem(study_.name));
    check_numbers("eccentricities", study_.eccentricities, "an eccentricity is from 0 to below 1",
                  [](double e) { return 0 <= e && e < 1; });
    check_numbers("sub_intervals", study_.sub_intervals,
                  "a period has a whole number of sub-intervals from 3 to 1e6",
                  [](double n) { return 3 <= n && n <= 1e6 && n == std::floor(n); });
    for (std::size_t k = 0; k < study_.checks.size(); ++k) check_check(k);
  }

 private:
  void require(bool holds, const std::string& key, const std::string& message) const {
    if (!holds) throw LocatedError(document_.locate(key), message);
  }

  template <class Rule>
  void check_numbers(const std::string& name, const std::vector<double>& numbers,
                     const std::string& rule_in_words, Rule rule) const {
    const std::string key = "interpolation." + name;
    require(!numbers.empty(), key, fmt::format("'{}' must not be empty", name));
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const std::string item = fmt::format("{}.{}", key, k);
      require(rule(numbers[k]), item, fmt::format("{}, and not {}", rule_in_words, numbers[k]));
      require(k == 0 || numbers[k] > numbers[k - 1], item,
              fmt::format("the numbers of '{}' must rise", name));
    }
  }

  void check_check(std::size_t k) const {
    const auto& [path, quantity, eccentricity, sub_intervals, limits] = study_.checks[k];
    const std::string key = fmt::format("check.{}", k);
    require(has(study_.eccentricities, eccentricity), key + ".eccentricity",
            fmt::format("the study has no eccentricity {}", eccentricity));
    require(has(study_.sub_intervals, static_cast<double>(sub_intervals)), key + ".sub_intervals",
            fmt::format("the study has no division into {} sub-intervals", sub_intervals));
    limits.refuse_senseless(document_.locate(key));
  }

  static bool has(const std::vector<double>& numbers, double number) {
    return std::ranges::find(numbers, number) != numbers.end();
  }

  const InterpolationStudy& study_;
  const Document& document_;
};

}  // namespace

Choices path_choices() {
  Choices choices;
  for_each_type(Paths{}, [&]<class Way>() { choices.push_back(choice_of<Way>()); });
  return choices;
}

bool is_interpolation_study(const Document& document) {
  return document.root().find("interpolation") != nullptr &&
         document.root().find("model") == nullptr;
}

InterpolationStudy read_interpolation_study(const Document& document) {
  InterpolationStudy study;
  Reader reader(document, "the study");
  describe(reader, study);
  reader.finish();
  Checker(study, document).check();
  return study;
}

std::string resolved_yaml(InterpolationStudy& study) {
  return yaml_of([&](Description& d) { describe(d, study); });
}

std::string interpolation_study_schema() {
  return schema_of("mote study of interpolation", [](Description& description) {
    InterpolationStudy study;
    describe(description, study);
  });
}

}  // namespace mote
