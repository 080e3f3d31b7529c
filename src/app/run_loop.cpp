#include "mote/app/run_loop.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "mote/app/history_checks.hpp"
#include "mote/app/neighbourhood.hpp"
#include "mote/app/one_line.hpp"
#include "mote/app/shared_folder.hpp"
#include "mote/output/files.hpp"
#include "mote/output/picture.hpp"

namespace mote {

std::vector<Reading> history_columns(Simulation& simulation, double time) {
  if (simulation.has_probes()) simulation.model().complete_fields();
  std::vector<Reading> columns;
  for (const Conserved& quantity : simulation.model().conserved())
    columns.push_back({quantity.name, quantity.value});
  std::ranges::move(simulation.observations(time), std::back_inserter(columns));
  return columns;
}

RunLoop::RunLoop(Simulation& simulation, OutputFolder& folder, Progress::Style style,
                 const Moment& start, const Restart& restart)
    : simulation_(simulation),
      folder_(folder),
      style_(style),
      progress_(style, start.time, simulation.scenario().time.end),
      start_(start),
      now_(start) {
  if (simulation_.follows_path()) {
    course_.emplace(simulation_.model(), simulation_.integrator(), simulation_.path(), start);
    if (!restart.empty()) course_->go_back_to(restart);
  } else if (!restart.empty()) {
    simulation_.integrator().recall(restart.integrator);
  }
}

int RunLoop::go_on() {
  const auto clock_start = std::chrono::steady_clock::now();
  std::chrono::duration<double> wall{0};
  const auto stop_clock = [&] { wall = std::chrono::steady_clock::now() - clock_start; };
  Certificate certificate;
  try {
    for (std::int64_t frame = start_.frame + 1; frame <= simulation_.plan().frames(); ++frame)
      run_to(frame);
    stop_clock();
    certificate = certificate_of(simulation_, now_);
    std::ranges::move(history_results(simulation_.scenario(), folder_.file("history.csv")),
                      std::back_inserter(certificate.checks));
  } catch (const NumericalFailure& broken) {
    stop_clock();
    certificate = failed_certificate(simulation_, now_, failure_message(broken));
  }
  progress_.end();
  certificate.wall_seconds = wall.count();
  certificate.steps_timed = now_.step - start_.step;
  certificate.threads = omp_get_max_threads();
  return conclude(std::move(certificate));
}

void RunLoop::run_to(std::int64_t frame) {
  course_ ? step_past(frame) : step_to(frame);
  now_.frame = frame;
  simulation_.model().complete_snapshot();
  const Restart from = course_ ? course_->restart() : simulation_.restart(now_);
  folder_.add_snapshot(now_, simulation_.fingerprint(), simulation_.model().cloud(),
                       scene_of(simulation_.model()), from);
  progress_.snapshot_done(now_.step, now_.time);
}

/// Where a step that breaks down is said to have been: nobody knows the end of one that the
/// integrator was to choose.
double RunLoop::meant_end(double start, const Step& step) const {
  return simulation_.integrator().chooses_steps() ? start : step.end;
}

/// Steps until one ends at the frame.
void RunLoop::step_to(std::int64_t frame) {
  simulation_.start_afresh();
  const double target = simulation_.plan().time_of_frame(frame);
  for (std::int64_t number = 1; now_.time < target; ++number) {
    const double before = now_.time;
    const Step step = simulation_.next_step(frame, number, before);
    now_ = {now_.frame, now_.step + 1, meant_end(before, step)};
    const double length = simulation_.advance(before, step.length);
    now_.time = length < step.length ? before + length : step.end;
    if (wants_row(frame, before, now_)) add_row(now_);
    progress_.step_done(now_.time);
  }
}

/// Steps until one ends at the frame or beyond it, and shows the state at the frame.
void RunLoop::step_past(std::int64_t frame) {
  const double target = simulation_.plan().time_of_frame(frame);
  course_->show_node();
  simulation_.model().stand_at(course_->node().time);
  while (course_->node().time < target) {
    if (std::exchange(row_is_due_, false)) add_row(course_->node());
    const Moment before = course_->node();
    course_->take_step([&] {
      const Step step = simulation_.next_free_step(before.step + 1, before.time);
      now_ = {now_.frame, before.step + 1, meant_end(before.time, step)};
      const double length = simulation_.advance(before.time, step.length);
      return length < step.length ? before.time + length : step.end;
    });
    now_ = course_->node();
    row_is_due_ = wants_row_between(frame, before.time, now_);
    progress_.step_done(std::min(now_.time, target));
  }
  now_ = {frame, course_->node().step, target};
  course_->show(target);
  simulation_.model().stand_at(target);
  add_row(now_);
}

void RunLoop::add_row(const Moment& moment) {
  folder_.history().add(moment, history_columns(simulation_, moment.time));
}

/// Whether a step that ends at or before a frame gets a row in the history: the last one to the
/// frame, and those between.
bool RunLoop::wants_row(std::int64_t frame, double before, const Moment& after) const {
  return after.time == simulation_.plan().time_of_frame(frame) ||
         wants_row_between(frame, before, after);
}

/// Every so many steps have a row, or those that pass a tenth of the way from frame to frame.
bool RunLoop::wants_row_between(std::int64_t frame, double before, const Moment& after) const {
  const TimePlan& plan = simulation_.plan();
  const double target = plan.time_of_frame(frame);
  const std::int64_t every = simulation_.scenario().output.history;
  if (plan.has_frame_at(after.time)) return false;  // the frame has a row of its own
  if (every > 0) return after.step % every == 0;
  const bool is_between = before >= plan.time_of_frame(frame - 1) && after.time < target;
  return is_between && plan.passes_tenth(frame, before, after.time);
}

std::string RunLoop::failure_message(const NumericalFailure& broken) const {
  const std::string around = neighbourhood(simulation_.model().cloud(), broken.particles());
  return fmt::format("step {}, t = {:.6g}: {}. Likely cause: {}. {}Last good snapshot: {}",
                     now_.step, now_.time, broken.what(), broken.cause(),
                     around.empty() ? "" : fmt::format("Particles there: {}. ", around),
                     folder_.snapshot(now_.frame).string());
}

int RunLoop::conclude(Certificate certificate) {
  const double drawn = simulation_.plan().time_of_frame(now_.frame);
  const Table curve = simulation_.exact() != nullptr ? simulation_.exact()->curve(drawn) : Table{};
  if (!curve.empty()) folder_.write_table("exact.csv", curve);
  write_file(folder_.file("summary.json"), summary_json(certificate));
  std::string picture;
  if (simulation_.scenario().output.picture) {
    const std::string problem = draw_pictures(shared_folder() / "plot", folder_.path());
    if (problem.empty()) {
      picture = "fields.png";
    } else {
      certificate.warnings.push_back("no picture: " + problem);
      write_file(folder_.file("summary.json"), summary_json(certificate));
    }
  }
  write_file(folder_.file("report.md"), report_markdown(certificate, picture));
  for (const auto& warning : certificate.warnings) fmt::print(stderr, "{}\n", one_line(warning));
  if (certificate.failure)
    fmt::print(stderr, "{}: numerical failure at {}\n", certificate.name,
               one_line(*certificate.failure));
  if (style_ != Progress::Style::quiet) print_outcome(certificate, picture);
  if (certificate.failure) return 3;
  return certificate.passed() ? 0 : 1;
}

void RunLoop::print_outcome(const Certificate& c, const std::string& picture) const {
  if (!c.failure) {
    fmt::print("{}: {} particles, {} steps to t = {:.6g} in {:.2g} s\n", c.name, c.particles,
               c.steps, c.time, c.wall_seconds);
    fmt::print("{}", checks_text(c.checks));
    if (c.checks.empty()) fmt::print("  the scenario states no check\n");
    if (c.pair_work.evaluations == 0) fmt::print("  no derivative was needed: see the report\n");
  }
  if (!picture.empty()) fmt::print("picture: {}\n", folder_.file(picture).string());
  fmt::print("report:  {}\n", folder_.file("report.md").string());
}

}  // namespace mote
