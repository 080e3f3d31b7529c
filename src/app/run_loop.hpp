#pragma once

#include <filesystem>
#include <optional>

#include "mote/app/path_course.hpp"
#include "mote/app/progress.hpp"
#include "mote/app/simulation.hpp"
#include "mote/output/folder.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

/// What a row of history.csv for this time holds beside time and step, with all fields brought up
/// to date.
std::vector<Reading> history_columns(Simulation& simulation, double time);

/// Steps a simulation from `start`, the state that it is in, to its end with snapshots and history,
/// writes the certificate and the picture, and says how it went. Returns the exit code: 0 every
/// check passed, 1 one failed, 3 the numerics failed.
class RunLoop {
 public:
  RunLoop(Simulation& simulation, OutputFolder& folder, Progress::Style style, const Moment& start,
          const Restart& restart = {});

  int go_on();

 private:
  void run_to(std::int64_t frame);
  void step_to(std::int64_t frame);
  void step_past(std::int64_t frame);
  bool wants_row(std::int64_t frame, double before, const Moment& after) const;
  bool wants_row_between(std::int64_t frame, double before, const Moment& after) const;
  double meant_end(double start, const Step& step) const;
  void add_row(const Moment& moment);
  int conclude(Certificate certificate);
  std::string failure_message(const NumericalFailure& broken) const;
  void print_outcome(const Certificate& certificate, const std::string& picture) const;

  Simulation& simulation_;
  OutputFolder& folder_;
  Progress::Style style_;
  Progress progress_;
  Moment start_, now_;
  std::optional<PathCourse> course_;  ///< where steps know nothing of frames
  bool row_is_due_ = false;           ///< for the end of the course's last step
};

}  // namespace mote
