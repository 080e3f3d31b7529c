#pragma once

#include <string>
#include <vector>

#include "mote/output/certificate.hpp"

namespace mote {

/// A table as rows of cells, the heads first; all rows have as many cells as these.
using TableRows = std::vector<std::vector<std::string>>;

/// The first two lines of a table in Markdown.
std::string markdown_head(const std::vector<std::string>& heads);

std::string markdown_table(const TableRows& rows);

/// The table in plain text, each column as wide as it must be.
std::string aligned_table(const TableRows& rows);

/// The beginning of study.md, for any kind of study: name, verdict, what was studied, checks and
/// pictures.
std::string report_beginning(const std::string& name, const std::string& about,
                             const std::vector<CheckResult>& checks,
                             const std::vector<std::string>& pictures);

/// Its end; `more` says what lies in the folder besides the tables of all studies.
std::string report_end(const std::string& more = "");

}  // namespace mote
