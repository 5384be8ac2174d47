#include "hexoderm/device/listening.h"

#include "tests/support/testing.h"

#include <numbers>

namespace hexoderm {
namespace {

SkinDescription threeCells() {
  return {Message::verbatim("three cells"),
          std::make_shared<const CellModel>(builtInCellModel("hex-bma150")),
          {{CellId(1), "", {{PortNumber(1), CellId(2), PortNumber(3)}}},
           {CellId(2), "", {{PortNumber(3), CellId(1), PortNumber(1)}}},
           {CellId(3), "", {{PortNumber(1), CellId(2), PortNumber(4)}}}}};
}

/// Simulated readings at 200 Hz of cells 1 and 2, while the part turns by a degree a second.
Listening heard(double noise_g, int frames) {
  Listening listening;
  listening.onSkin(threeCells());
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, noise_g);
  for (int k = 0; k < frames; ++k) {
    SampleFrame frame{10 + 0.005 * k};
    const double angle = 0.0175 * 0.005 * k;
    for (const std::uint32_t cell : {1U, 2U}) {
      frame.samples.push_back({CellId(cell), Eigen::Vector3d(std::sin(angle) + noise(random), noise(random),
                                                             std::cos(angle) + noise(random))});
    }
    listening.onFrame(frame);
  }
  return listening;
}

TEST(Listening, MeasuresRatesNormsAndNoise) {
  const ListeningReport report = heard(0.02, 4000).report();
  EXPECT_TRUE(report.is_described);
  EXPECT_EQ(report.obstacle, Message());
  ASSERT_EQ(report.cells.size(), 3U);
  EXPECT_EQ(report.cells[0].readings, 4000U);
  EXPECT_NEAR(*report.cells[0].rate_hz, 200, 1e-6);
  EXPECT_NEAR(*report.cells[0].noise_g, 0.02, 0.001);
  EXPECT_NEAR(report.norm_g->median, 1, 0.005);
  EXPECT_LT(report.norm_g->least, 0.97);
  EXPECT_FALSE(report.cells[2].norm_g);
  EXPECT_FALSE(report.cells[2].mean_u);
  EXPECT_THAT(report.silent_cells, ElementsAre(CellId(3)));
  EXPECT_EQ(report.links_agreed, 1U);
  EXPECT_EQ(report.links_one_sided, 1U);
}

TEST(Listening, AClockThatStartsAgainAndAbsurdReadingsLeaveMetricsFinite) {
  Listening listening = heard(0.02, 200);
  for (const double time_s : {0.0, 0.005}) listening.onFrame({time_s, {{CellId(1), Eigen::Vector3d::Constant(3e38)}}});
  const ListeningReport report = listening.report();
  EXPECT_NEAR(*report.cells[0].rate_hz, 200, 1e-6);
  EXPECT_EQ(report.cells[0].norm_g->most, 1e6);
  EXPECT_TRUE(std::isfinite(*report.cells[0].noise_g));
}

TEST(Listening, MeansAreAlongTheAxesOfTheCell) {
  CellModel model = builtInCellModel("hex-bma150");
  model.accelerometer.T_u_a.R = Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  SkinDescription skin = threeCells();
  skin.model = std::make_shared<const CellModel>(model);
  Listening listening;
  listening.onSkin(skin);
  listening.onFrame({0, {{CellId(1), {0.9, 0.1, 0.2}}}});
  listening.onFrame({0.01, {{CellId(1), {1.1, 0.1, 0.2}}}});
  const Eigen::Vector3d mean_u = *listening.report().cells[0].mean_u;
  EXPECT_NEAR((mean_u - Eigen::Vector3d(-0.1, 1, 0.2)).norm(), 0, 1e-12) << mean_u;
}

TEST(Listening, SaysThatALineIsTooSlow) {
  const auto heardAt = [](double device_hz, double host_hz, const SourceStatus& status = {}) {
    Listening listening;
    listening.onSkin(threeCells());
    listening.onStatus(status);
    const Listening::Clock::time_point begin{};
    for (int k = 0; k < 200; ++k) {
      const SampleFrame frame{5 + k / device_hz, {{CellId(1), {0, 0, 1}}, {CellId(2), {0, 0, 1}}}};
      const auto since = std::chrono::duration<double>(k / host_hz);
      listening.add(frame, begin + std::chrono::duration_cast<Listening::Clock::duration>(since));
    }
    return listening.report();
  };
  const ListeningReport slow = heardAt(100, 30);
  EXPECT_NEAR(*slow.slowness, 3.33, 0.01);
  ASSERT_EQ(slow.remarks.size(), 1U);
  EXPECT_THAT(slow.remarks[0].english(), HasSubstr("arrives 3.3 times slower than the device's clock says"));
  EXPECT_THAT(heardAt(30, 30).remarks, testing::IsEmpty());
  // Of times in milliseconds the offence says more.
  SourceStatus status;
  status.offences = {{ProtocolViolationKind::TimeUnit, message("milliseconds?")}};
  EXPECT_THAT(heardAt(1e5, 1000.0 / 30, status).remarks, testing::IsEmpty());
}

TEST(Listening, SaysWhatACaptureWouldSayOfLinks) {
  SkinDescription skin = threeCells();
  for (CellReport& cell : skin.neighbors) cell.neighbors = {{PortNumber(0), CellId(2), {}}};
  Listening all_from_zero = heard(0.02, 100);
  all_from_zero.onSkin(skin);
  EXPECT_THAT(all_from_zero.report().obstacle.english(), HasSubstr("are the ports counted from 0?"))
      << "where no link is left, too";
  skin = threeCells();
  skin.neighbors[0].neighbors.push_back({PortNumber(0), CellId(2), {}});
  Listening from_zero = heard(0.02, 100);
  from_zero.onSkin(skin);
  EXPECT_THAT(from_zero.report().obstacle.english(), HasSubstr("are the ports counted from 0?"));
  skin = threeCells();
  skin.neighbors.push_back({CellId(4), "", {}});
  skin.neighbors.push_back({CellId(5), "", {}});
  Listening lone = heard(0.02, 100);
  lone.onSkin(skin);
  EXPECT_EQ(lone.report().obstacle.english(), "3 of 5 cells are linked to no other: nothing says how they lie.");
}

TEST(Listening, SaysWhyNoCalibrationCouldBegin) {
  EXPECT_THAT(Listening().report().obstacle.english(), HasSubstr("has not described itself"));
  EXPECT_THAT(heard(0, 0).report().obstacle.english(), HasSubstr("No readings came."));
  EXPECT_THAT(heard(0, 1).report().obstacle.english(), HasSubstr("No cell sent two readings"));
  Listening alone = heard(0.02, 100);
  SkinDescription skin = threeCells();
  for (CellReport& cell : skin.neighbors) cell.neighbors.clear();
  alone.onSkin(skin);
  EXPECT_THAT(alone.report().obstacle.english(), HasSubstr("There is no link that both of its cells report"));
}

}  // namespace
}  // namespace hexoderm
