#include "mote/app/run_loop.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <chrono>

#include "mote/app/one_line.hpp"
#include "mote/app/shared_folder.hpp"
#include "mote/output/files.hpp"
#include "mote/output/picture.hpp"
#include "mote/particles/failure.hpp"

namespace mote {

RunLoop::RunLoop(Simulation& simulation, OutputFolder& folder, Progress::Style style,
                 const Moment& start)
    : simulation_(simulation),
      folder_(folder),
      style_(style),
      progress_(style, simulation.plan().total_steps(), start.step),
      start_(start),
      now_(start) {}

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
  } catch (const NumericalFailure& broken) {
    stop_clock();
    certificate = failed_certificate(
        simulation_, now_, failure_message(broken.what(), broken.particles(), broken.cause()));
  }
  progress_.end();
  certificate.wall_seconds = wall.count();
  certificate.steps_timed = now_.step - start_.step;
  certificate.threads = omp_get_max_threads();
  return conclude(std::move(certificate));
}

void RunLoop::run_to(std::int64_t frame) {
  const TimePlan& plan = simulation_.plan();
  Model& model = simulation_.model();
  const double step = plan.step_to(frame);
  simulation_.integrator().forget_rounding();
  for (std::int64_t k = 1; k <= plan.steps_to(frame); ++k) {
    const double time = now_.time;
    now_ = {now_.frame, now_.step + 1, plan.time(frame, k)};
    simulation_.advance(time, step);
    const bool last = k == plan.steps_to(frame);
    if (last || now_.step % simulation_.scenario().output.history == 0)
      folder_.history().add(now_, model.conserved());
    progress_.step_done(now_.step, now_.time);
  }
  now_.frame = frame;
  folder_.add_snapshot(now_, simulation_.fingerprint(), model.cloud());
  progress_.snapshot_done(now_.step, now_.time);
}

std::string RunLoop::failure_message(const std::string& what, const std::vector<Index>& particles,
                                     const std::string& cause) const {
  std::string neighbourhood;
  const auto position = simulation_.model().cloud().position();
  const Index count = simulation_.model().cloud().count();
  for (Index i = std::max(0, particles.front() - 1); i <= std::min(count - 1, particles.back() + 1);
       ++i)
    neighbourhood +=
        fmt::format("{}{} at {:.6g}", neighbourhood.empty() ? "" : ", ", i, position[i]);
  return fmt::format(
      "step {}, t = {:.6g}: {}. Likely cause: {}. Particles there: {}. Last good snapshot: {}",
      now_.step, now_.time, what, cause, neighbourhood, folder_.snapshot(now_.frame).string());
}

int RunLoop::conclude(Certificate certificate) {
  const double drawn = simulation_.plan().time_of_frame(now_.frame);
  if (simulation_.exact() != nullptr)
    folder_.write_table("exact.csv", simulation_.exact()->curve(drawn));
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
