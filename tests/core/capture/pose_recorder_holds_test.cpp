// Every hold is captured, once, and no motion is.

#include "hexoderm/sim/simulated_skin.h"
#include "tests/core/capture/pose_recorder_fixture.h"
#include "tests/support/options.h"

namespace hexoderm::pose_recorder_test {
namespace {

/// Sets a simulated skin and feeds holds of it, joined by moves of 1 s in which every cell's reading goes straight to
/// where it will be and is 1 g.
template <class AfterMove, class AfterHold>
void feedHolds(SimulatedSkin& skin, PoseRecorder& recorder, std::size_t poses, std::size_t hold_frames,
               const AfterMove& after_move, const AfterHold& after_hold) {
  recorder.setSkin({Message::verbatim("simulated"), std::make_shared<CellModel>(skin.model()), skin.neighbors()});
  double time_s = 0;
  std::vector<CellSample> last;
  for (const Eigen::Vector3d& up : scriptedUpDirections(poses)) {
    std::vector<SampleFrame> hold = skin.record(up, hold_frames);
    for (int k = 1; k < 1000 && !last.empty(); ++k) {
      SampleFrame move{time_s += 0.001};
      for (std::size_t c = 0; c < last.size(); ++c) {
        const Eigen::Vector3d& from = last[c].acceleration_g;
        const Eigen::Vector3d& to = hold.front().samples[c].acceleration_g;
        move.samples.push_back({last[c].cell, from == to ? from : (from + k * (to - from) / 1000).normalized()});
      }
      recorder.addFrame(move);
    }
    after_move();
    for (SampleFrame& frame : hold) {
      frame.time_s = time_s += 0.001;
      recorder.addFrame(frame);
    }
    last = hold.back().samples;
    after_hold();
  }
}

TEST(PoseRecorder, CapturesEveryHoldOfASimulatedSkinOnceWhateverIsBroken) {
  std::vector<std::optional<SkinFault>> faults = {std::nullopt};
  for (const SkinFault fault : {SkinFault::Dead, SkinFault::Stuck, SkinFault::StuckAxis, SkinFault::Saturated,
                                SkinFault::Noisy, SkinFault::NoSamples, SkinFault::WrongGain, SkinFault::DeadAxis}) {
    faults.emplace_back(fault);
  }
  for (const std::optional<SkinFault>& fault : faults) {
    SCOPED_TRACE(fault ? static_cast<int>(*fault) : -1);
    SimulatedSkinOptions options;
    if (fault) options.faults = {{*fault, CellId(1)}, {*fault, CellId(9)}, {*fault, CellId(14)}};
    SimulatedSkin skin(builtInCellModel("hex-bma150"), options);
    Captures captures;
    PoseRecorder recorder(captures);
    std::size_t held = 0;
    feedHolds(
        skin, recorder, 3, 4500, [&] { EXPECT_THAT(captures.poses, SizeIs(held)) << "captured on the way"; },
        [&] { EXPECT_THAT(captures.poses, SizeIs(++held)) << captures.holds.back().message.english(); });
    if (fault == SkinFault::NoSamples) {
      EXPECT_THAT(captures.poses.back().silent_cells, ElementsAre(CellId(1), CellId(9), CellId(14)));
    }
  }
}

TEST_F(PoseRecorderTest, MotionStartsTheHoldOver) {
  SyntheticStream stream = held(1.2, cells(3));
  stream.move(30 * kDegree, 0.5);
  const double held_from_s = stream.hold(4).first;
  PoseRecorder recorder(captures_, test::with(&PoseRecorderOptions::samples_per_cell, 1000));
  feed(recorder, stream.frames);
  ASSERT_THAT(captures_.poses, SizeIs(1));
  EXPECT_GT(captures_.poses.front().start_s, held_from_s);
  EXPECT_EQ(captures_.poses.front().pose->samples.front().count, 1000U);
  EXPECT_EQ(captures_.holds.back().restarts, 1U);

  // The ring grows while the part is held, falls with the motion, and ends full.
  double before_move = 0, after_move = 1, last = 0;
  for (const HoldStatus& hold : captures_.holds) {
    const double time_s = hold.stillness.time_s;
    EXPECT_GE(hold.progress, 0);
    EXPECT_LE(hold.progress, 1);
    if (time_s < 11.2) before_move = std::max(before_move, hold.progress);
    if (time_s > 11.4 && time_s < 11.8) after_move = std::min(after_move, hold.progress);
    if (time_s <= captures_.poses.front().end_s + 0.1) last = hold.progress;
  }
  EXPECT_GT(before_move, 0.4);
  EXPECT_LT(after_move, 0.1);
  EXPECT_GT(last, 0.9);
}

/// Holds of one cell or several, at many rates, with and without noise, apart by moves of 6 to 180 degrees, and slow
/// turns of 3 deg/s: every hold is captured, and nothing while the part turns.
TEST(PoseRecorder, CapturesHoldsAndNothingElse) {
  int holds = 0, captured_holds = 0;
  unsigned seed = 0;
  for (const double rate_hz : {50.0, 100.0, 333.0, 1000.0}) {
    for (const double noise_g : {0.0003, 0.003, 0.011}) {
      StreamOptions options = cells(1 + seed % 3, rate_hz);
      options.noise_g = noise_g;
      options.lsb_g = noise_g / 3;
      options.offset_g = 0.1;
      options.gain = 0.9;
      options.jitter = 0.05;
      options.seed = ++seed;
      SyntheticStream stream(options);
      std::vector<std::pair<double, double>> truth = {stream.hold(3)};
      for (const double angle_deg : {6.0, 90.0, 15.0, 180.0}) {
        const double speed_deg_s = std::exp(stream.uniform(std::log(15), std::log(200)));
        stream.move(angle_deg * kDegree, std::max(0.3, angle_deg / speed_deg_s));
        stream.turn(3 * kDegree, 3);
        truth.push_back(stream.hold(stream.uniform(2.5, 6)));
      }
      Captures captures;
      PoseRecorder recorder(captures);
      recorder.setSkin(skinOf(options.cells, rate_hz));
      feed(recorder, stream.frames);
      holds += static_cast<int>(truth.size());
      for (const CapturedPose& captured : captures.poses) {
        // At the end of a move the part counts as still a little early, once its speed is below 1 deg/s.
        const bool inside = std::ranges::any_of(truth, [&](const auto& hold) {
          return captured.start_s >= hold.first - 0.2 && captured.end_s <= hold.second;
        });
        EXPECT_TRUE(inside) << "seed " << seed << ": captured from " << captured.start_s << " s on";
        captured_holds += inside ? 1 : 0;
      }
      EXPECT_LE(captures.poses.size(), truth.size()) << "seed " << seed;
    }
  }
  EXPECT_EQ(captured_holds, holds);
}

}  // namespace
}  // namespace hexoderm::pose_recorder_test
