#include "mote/study/study_file.hpp"

#include <fmt/format.h>

#include "mote/scenario/reader.hpp"
#include "mote/scenario/schema.hpp"
#include "mote/scenario/writer.hpp"
#include "mote/study/complete_study.hpp"
#include "mote/study/difference_table.hpp"
#include "mote/study/interpolation_study.hpp"

namespace mote {

bool is_study(const Document& document) {
  if (is_difference_table(document) || is_interpolation_study(document)) return true;
  return document.root().find("field") != nullptr && document.root().find("model") == nullptr;
}

StudyFile read_study(const Document& document, const Catalogue& catalogue) {
  StudyFile study;
  Reader reader(document, "the study");
  describe(reader, study, catalogue);
  reader.finish();
  complete(study, document);
  return study;
}

std::string resolved_yaml(StudyFile& study, const Catalogue& catalogue) {
  return yaml_of([&](Description& d) { describe(d, study, catalogue); });
}

/// A study is of one of these kinds; their schemas share no definitions.
std::string study_schema(const Catalogue& catalogue) {
  const std::string of_operators = schema_of("mote study of operators", [&](Description& d) {
    StudyFile study;
    describe(d, study, catalogue);
  });
  return fmt::format(
      "{{\"$schema\": \"https://json-schema.org/draft/2020-12/schema\", \"title\": \"mote "
      "study\",\n"
      "\"anyOf\": [{},\n{},\n{}]}}",
      of_operators, difference_table_schema(), interpolation_study_schema());
}

}  // namespace mote
