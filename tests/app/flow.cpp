#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "flow_runs.hpp"
#include "support/csv_rows.hpp"

namespace mote::test {
namespace {

using nlohmann::json;

/// A column of water that begins to fall in a tank, with particles enough for several threads.
constexpr const char* tank = R"(name: tank
dimension: 2
domain: {lower: [0, 0], upper: [1, 0.6], walls: [{side: x_lower}, {side: x_upper}, {side: y_lower}]}
particles: {spacing: 0.01}
regions:
  - {name: water, type: fluid, shapes: [{type: box, lower: [0, 0], upper: [0.9, 0.5]}]}
model:
  {type: weakly_compressible, density: 1000, sound_speed: 22, gravity: [0, -9.81],
   free_surface: true}
operator: {family: sph, kernel: wendland_c2}
time: {end: 0.02}
output: {every: 0.005, picture: false}
)";

/// A block of water that leaves an open domain, row by row.
constexpr const char* outflow = R"(name: outflow
dimension: 2
domain: {lower: [0, 0], upper: [0.2, 0.2]}
particles: {spacing: 0.01}
initial: {velocity_y: "-10"}
model: {type: weakly_compressible, density: 1000, sound_speed: 100, free_surface: true}
operator: {family: sph, kernel: wendland_c2}
time: {end: 0.02}
output: {every: 0.005, picture: false}
)";

class Flow : public FlowRuns {
 protected:
  std::vector<std::vector<double>> exported(const fs::path& out) const {
    const std::string csv = (folder_ / "frame.csv").string();
    EXPECT_EQ(mote({"export", out.string(), "--to", csv, "--overwrite"}).exit_code, 0);
    return rows_of(read(csv));
  }
};

TEST_F(Flow, HasTheSameBitsForAnyNumberOfThreads) {
  expect_same_bits_for_any_number_of_threads(tank);
}

TEST_F(Flow, HasTheSameBitsAfterAResume) { expect_same_bits_after_a_resume(tank, {"1", "2", "4"}); }

/// Negative control of the comparisons above.
TEST_F(Flow, HasOtherBitsWithAnotherCourantNumber) {
  const fs::path whole = run(tank, "whole");
  const fs::path other = run(tank, "other", {"--set", "time.courant=0.2"});
  EXPECT_FALSE(read(whole / frames[4]) == read(other / frames[4]));
}

TEST_F(Flow, HitsEveryFrameWithStepsOfItsOwn) {
  const fs::path out = run(tank, "out");
  const json series = json::parse(read(out / "snapshots.hdf.series"));
  std::vector<double> times;
  for (const json& file : series["files"]) times.push_back(file["time"]);
  EXPECT_EQ(times, (std::vector<double>{0, 0.005, 2 * 0.005, 3 * 0.005, 0.02}));
  EXPECT_GT(json::parse(read(out / "summary.json"))["steps"], 40);
}

TEST_F(Flow, TellsConservationAndMemoryInTheSummary) {
  const json summary = json::parse(read(run(tank, "out") / "summary.json"));
  EXPECT_EQ(summary["dimension"], 2);
  EXPECT_TRUE(summary["conservation"].contains("momentum_x"));
  EXPECT_EQ(summary["conservation"]["mass"]["drift"], 0);
  EXPECT_GT(summary["bytes_per_particle"], 100);
}

TEST_F(Flow, IsExportedInOrderOfIds) {
  const auto rows = exported(run(tank, "out"));
  ASSERT_GT(rows.size(), 4500);
  for (std::size_t k = 0; k < rows.size(); ++k) ASSERT_EQ(rows[k][0], k);
}

TEST_F(Flow, GoesOnWithoutTheParticlesThatLeftTheDomain) {
  const fs::path whole = run(outflow, "whole");
  expect_same(whole, resumed(whole, "resumed", "2"));
  const auto rows = exported(whole);
  const auto last = rows_of(read(whole / "history.csv")).back();
  const double removed = last[last.size() - 2];  // before the angular momentum
  EXPECT_GT(removed, 0);
  EXPECT_EQ(static_cast<double>(rows.size()) + removed, 400);
  EXPECT_TRUE(std::ranges::is_sorted(rows, {}, [](const auto& row) { return row[0]; }));
}

TEST_F(Flow, HasAPictureOfItsParticles) {
  const fs::path out = run(tank, "out", {"--set", "output.picture=true"});
  EXPECT_EQ(read(out / "fields.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace mote::test
