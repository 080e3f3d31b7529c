#pragma once

#include <string>

#include "mote/study/run_study.hpp"
#include "mote/study/study_tables.hpp"
#include "support/program.hpp"

namespace mote::test {

/// A study from the text of its file, in a folder of its own.
struct WrittenStudy {
  explicit WrittenStudy(const std::string& text)
      : document(Document::from_file(write(folder / "study.yaml", text).string())),
        study(read_study(document, catalogue)) {}

  /// Runs it and writes points.csv, and check_up.csv if there is one, into the folder.
  StudyResult run() const {
    CaseTables tables(folder.path(), true);
    StudyResult result = run_study(document, study, catalogue, folder.path(),
                                   [&](const StudyCase& done) { tables.add(done); });
    tables.finish();
    return result;
  }

  TemporaryFolder folder;
  Catalogue catalogue = standard_catalogue();
  Document document;
  StudyFile study;
};

}  // namespace mote::test
