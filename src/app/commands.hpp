#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mote/catalogue/entries.hpp"

namespace mote {

/// Options of `mote run`, `mote study`, `mote check` and `mote resume`.
struct RunOptions {
  std::string file;
  std::vector<std::string> assignments;  ///< of --set, `key.path=value`
  std::optional<std::string> out;        ///< none: a new folder below `results`
  int threads = 0;                       ///< 0: the scenario's, or all there are
  bool overwrite = false;
  bool quiet = false;
  bool strict = false;  ///< whether warnings are errors
};

/// Options of `mote compare`.
struct CompareOptions : RunOptions {
  std::vector<std::string> variations;  ///< of --vary, `key.path=value,value,...`
  int jobs = 0;                         ///< 0: as many as there are processors and memory for
};

struct ExportOptions {
  std::string folder;
  std::string frame = "last";
  std::string to;
  bool overwrite = false;
};

/// Options of `mote sum`.
struct SumOptions {
  std::string points;                  ///< file of the sources
  std::optional<std::string> targets;  ///< file; none: the sources
  std::string kernel;
  std::string method = "multipole";
  double tolerance = 1e-8;
  std::optional<std::string> core;
  std::optional<double> core_size;
  std::string out;
  int threads = 0;  ///< 0: all there are
  bool gradient = false, verify = false, overwrite = false, quiet = false;
};

/// The commands of mote, one file each. They return the exit code, and throw LocatedError or
/// InputError for bad input.
int run(const Catalogue& catalogue, const RunOptions& options);
int study(const Catalogue& catalogue, const RunOptions& options);
int compare(const Catalogue& catalogue, const CompareOptions& options);
int check(const Catalogue& catalogue, const RunOptions& options);
int resume(const Catalogue& catalogue, const RunOptions& options);
int export_frame(const ExportOptions& options);
int sum(const SumOptions& options);
int list(const Catalogue& catalogue, const std::string& what);
int print_schema(const Catalogue& catalogue, const std::string& of);

/// What `mote list` can list.
std::vector<std::string> listable();

}  // namespace mote
