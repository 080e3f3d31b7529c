#pragma once

#include <filesystem>

#include "mote/app/children.hpp"
#include "mote/app/commands.hpp"
#include "mote/compare/compare_report.hpp"

namespace mote {

/// Runs the members of a comparison in processes of their own: HDF5 is not made for threads, and
/// one that crashes is a row like others. After each, compare.csv is written anew and a line says
/// how it ended.
class MemberRuns {
 public:
  MemberRuns(const CompareOptions& options, const Running& running,
             const std::filesystem::path& folder, CompareTable& table)
      : options_(options), running_(running), folder_(folder), table_(table) {}

  void run_all();

 private:
  void start(std::size_t member);
  void finish(const EndedChild& ended);
  std::vector<std::string> arguments_of(const Member& member) const;

  const CompareOptions& options_;
  const Running& running_;
  const std::filesystem::path& folder_;
  CompareTable& table_;
  Children children_;
};

}  // namespace mote
