#include "mote/study/study_file.hpp"

#include <yaml-cpp/yaml.h>

#include "mote/scenario/reader.hpp"
#include "mote/scenario/schema.hpp"
#include "mote/scenario/writer.hpp"
#include "mote/study/complete_study.hpp"

namespace mote {

bool is_study(const Document& document) {
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
  YAML::Emitter out;
  out << YAML::BeginMap;
  Writer writer(out);
  describe(writer, study, catalogue);
  out << YAML::EndMap;
  return std::string(out.c_str()) + "\n";
}

std::string study_schema(const Catalogue& catalogue) {
  return schema_of("mote study", [&](Description& description) {
    StudyFile study;
    describe(description, study, catalogue);
  });
}

}  // namespace mote
