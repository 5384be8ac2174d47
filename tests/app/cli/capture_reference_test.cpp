// A real recording through the real program.

#include "hexoderm/session/session_store.h"

#include "tests/app/cli/cli_program.h"

#include <ostream>

namespace hexoderm {
namespace {

class CaptureOfARecording : public Cli {};

// 200 s of an accelerometer that was laid by hand in 13 orientations, with motion between.
TEST_F(CaptureOfARecording, FindsEveryPeriodOfRestOnceAndNoMotion) {
  const std::string table = HEXODERM_REFERENCE_DATA "/real/xsens_static_poses_part1.csv";
  const Outcome outcome = run("capture --source stdin --keep-raw -o table.hexo",
                              "python3 '" HEXODERM_CSV_SENDER "' '" + table + "' 32768 4070 | ");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const SessionStore store = SessionStore::openReadOnly(path("table.hexo"));
  const Session session = store.readSession();
  ASSERT_EQ(session.poses().size(), 13U);
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 13; ++k) {
    const Eigen::Vector3d mean = session.poses()[k].capture->samples.front().mean_g;
    EXPECT_GT((mean - before).norm(), 0.1) << "pose " << k + 1 << " repeats the one before";
    before = mean;
    // A motion anywhere among the samples would show: at rest this sensor scatters by a few mg.
    for (const SampleFrame& frame : store.readRawSamples(k)) {
      for (const CellSample& sample : frame.samples) {
        EXPECT_LT((sample.acceleration_g - mean).norm(), 0.06) << "pose " << k + 1 << " at " << frame.time_s << " s";
      }
    }
  }
}

/// The leg of a robot with its motors on, as it was read and as its port sends it: every reading four or five times.
struct RobotStream {
  const char* name;
  bool has_dead_board;
};
void PrintTo(const RobotStream& stream, std::ostream* out) { *out << stream.name; }

class CaptureOfARobot : public Cli, public ::testing::WithParamInterface<RobotStream> {};

TEST_P(CaptureOfARobot, FindsExactlyTheThreeHolds) {
  // By the encoders of the joints.
  constexpr std::array<std::pair<double, double>, 3> kHeld_s = {{{0, 8.0}, {11.8, 14.9}, {19.0, 33.2}}};
  const std::string stream = HEXODERM_REFERENCE_DATA "/real/icub_leg/" + std::string(GetParam().name);
  const Outcome outcome = run("capture --source stdin --keep-raw -o leg.hexo", "cat '" + stream + "' | ");
  EXPECT_NE(outcome.exit_code, 4) << outcome.err;
  const SessionStore store = SessionStore::openReadOnly(path("leg.hexo"));
  const Session session = store.readSession();
  ASSERT_EQ(session.poses().size(), kHeld_s.size()) << outcome.err << outcome.out;
  for (std::size_t k = 0; k < kHeld_s.size(); ++k) {
    const std::vector<SampleFrame> frames = store.readRawSamples(k);
    ASSERT_FALSE(frames.empty());
    EXPECT_GE(frames.front().time_s, kHeld_s[k].first) << "pose " << k + 1;
    EXPECT_LE(frames.back().time_s, kHeld_s[k].second) << "pose " << k + 1;
    for (const GravitySample& sample : session.poses()[k].capture->samples) {
      EXPECT_NEAR(sample.count, 15, 3) << "0.75 s at 20 Hz, however often each reading was sent";
    }
  }
  EXPECT_THAT(outcome.err, HasSubstr("Pose 3 captured: " + std::to_string(GetParam().has_dead_board ? 11 : 10) +
                                     " cells; it repeats pose 1"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("it repeats pose 2")));
  const bool names_it = outcome.err.find("Cell 43 is dead") != std::string::npos;
  EXPECT_EQ(names_it, GetParam().has_dead_board) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(Streams, CaptureOfARobot,
                         ::testing::Values(RobotStream{"readings_20hz.jsonl", true},
                                           RobotStream{"readings_20hz_quiet_model.jsonl", false},
                                           RobotStream{"port_frames_100hz.jsonl", true}));

}  // namespace
}  // namespace hexoderm
