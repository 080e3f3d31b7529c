#include "mote/app/member_runs.hpp"

#include <fmt/format.h>

#include "mote/app/one_line.hpp"
#include "mote/output/files.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

void MemberRuns::run_all() {
  const std::size_t count = table_.comparison().members.size();
  for (std::size_t next = 0; next < count || children_.running() > 0;)
    if (next < count && children_.running() < running_.jobs)
      start(next++);
    else
      finish(children_.wait_for_one());
}

std::vector<std::string> MemberRuns::arguments_of(const Member& member) const {
  std::vector<std::string> assignments = assignments_of(table_.comparison(), member);
  assignments.emplace_back("output.picture=false");
  // The copy, not the file: that may change while members run.
  std::vector<std::string> arguments{"run", (folder_ / "compare.yaml").string()};
  for (const std::string& assignment : assignments)
    arguments.insert(arguments.end(), {"--set", assignment});
  arguments.insert(arguments.end(), {"--threads", std::to_string(running_.threads), "--quiet",
                                     "--overwrite", "--out", (folder_ / member.folder).string()});
  if (options_.strict) arguments.emplace_back("--strict");
  return arguments;
}

void MemberRuns::start(std::size_t member) {
  const Member& started = table_.comparison().members[member];
  if (!started.suits()) return finish({member, started.unsuited});
  try {
    children_.start(member, arguments_of(started), folder_ / (started.folder + ".log"));
  } catch (const InputError& error) {
    finish({member, error.what()});
  }
}

void MemberRuns::finish(const EndedChild& ended) {
  const Member& member = table_.comparison().members[ended.number];
  table_.add(row_of(ended.number, folder_ / member.folder, ended.problem));
  write_file(folder_ / "compare.csv", compare_csv(table_));
  if (options_.quiet) return;
  const Row& row = *table_.of(ended.number);
  const std::string seconds = row.run ? fmt::format(", {:.2g} s", row.run->wall_seconds) : "";
  fmt::print("[{}/{}] {}{}: {}\n", table_.rows().size(), table_.comparison().members.size(),
             table_.comparison().label(member), seconds, one_line(verdict(row)));
  std::fflush(stdout);
}

}  // namespace mote
