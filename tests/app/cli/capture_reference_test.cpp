// A real recording through the real program.

#include "hexoderm/session/session_store.h"

#include "tests/app/cli/cli_program.h"

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

}  // namespace
}  // namespace hexoderm
