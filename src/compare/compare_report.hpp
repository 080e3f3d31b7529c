#pragma once

#include <string>

#include "mote/compare/compare_table.hpp"

namespace mote {

/// How the members were run, for the report.
struct Running {
  std::size_t jobs = 1;  ///< members that ran beside each other
  int threads = 1;       ///< of each
};

/// How a member ended in a few words: `passed`, `check failed: ...`, `failed at t = 1.27: ...`.
std::string verdict(const Row& row);

/// compare.md, the comparison for a person; shows `picture` if there is one.
std::string compare_markdown(const CompareTable& table, const Running& running,
                             const std::string& picture);

/// The same table as lines for a terminal.
std::string compare_text(const CompareTable& table);

}  // namespace mote
