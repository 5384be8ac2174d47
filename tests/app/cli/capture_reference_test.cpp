// Real recordings through the real program: every period of rest is captured once, and no motion.

#include "hexoderm/session/session_store.h"

#include "tests/app/cli/cli_program.h"

#include <ostream>

namespace hexoderm {
namespace {

struct Recorded {
  const char* name;
  std::string sender;                             ///< the command that sends it
  std::vector<std::pair<double, double>> held_s;  ///< found without the detector
  std::uint32_t samples;                          ///< of each cell in a pose: 0.75 s, however often a reading is sent
  std::vector<std::string> says, does_not_say;
};
void PrintTo(const Recorded& recorded, std::ostream* out) { *out << recorded.name; }

/// 200 s of an accelerometer that was laid by hand in 13 orientations, on some sides twice. Held is where the standard
/// deviation over 0.5 s (rms of the axes) stays below 6 mg for longer than 1.5 s; in between it is hundreds of mg.
Recorded laidByHand(const char* name, const std::string& counts, std::uint32_t samples) {
  const std::vector held_s = {std::pair(0.03, 52.62),    std::pair(54.72, 64.17),   std::pair(66.97, 76.72),
                              std::pair(79.62, 89.12),   std::pair(92.47, 102.87),  std::pair(105.87, 113.77),
                              std::pair(116.22, 125.47), std::pair(128.22, 135.87), std::pair(138.07, 147.91),
                              std::pair(152.36, 161.11), std::pair(164.31, 172.21), std::pair(176.21, 188.31),
                              std::pair(192.41, 199.96)};
  const std::string table = HEXODERM_REFERENCE_DATA "/real/xsens_static_poses_part1.csv";
  return {name,
          "python3 '" HEXODERM_CSV_SENDER "' '" + table + "' " + counts,
          held_s,
          samples,
          {"Pose 4 captured: 1 cell; it repeats pose 1", "Pose 6 captured: 1 cell; it repeats pose 2",
           "Pose 8 captured: 1 cell; it repeats pose 3"},
          {"Pose 9 captured: 1 cell; it repeats"}};
}

/// The leg of a robot with its motors on, as it was read and as its port sends it: every reading four or five times.
/// Held by the encoders of the joints.
Recorded legOfARobot(const char* name, bool has_dead_board) {
  const std::string dead = "Cell 43 is dead";
  const std::string cells = has_dead_board ? "11" : "10";
  Recorded recorded{name,
                    "cat '" HEXODERM_REFERENCE_DATA "/real/icub_leg/" + std::string(name) + "'",
                    {{0, 8.0}, {11.8, 14.9}, {19.0, 33.2}},
                    15,
                    {"Pose 3 captured: " + cells + " cells; it repeats pose 1"},
                    {"it repeats pose 2"}};
  (has_dead_board ? recorded.says : recorded.does_not_say).push_back(dead);
  return recorded;
}

class CaptureOfARecording : public Cli, public ::testing::WithParamInterface<Recorded> {};

TEST_P(CaptureOfARecording, FindsEveryPeriodOfRestOnceAndNoMotion) {
  const Recorded& recorded = GetParam();
  const Outcome outcome = run("capture --source stdin --keep-raw -o a.hexo", recorded.sender + " | ");
  EXPECT_NE(outcome.exit_code, 4) << outcome.err;
  const SessionStore store = SessionStore::openReadOnly(path("a.hexo"));
  const Session session = store.readSession();
  ASSERT_EQ(session.poses().size(), recorded.held_s.size()) << outcome.err << outcome.out;
  for (std::size_t k = 0; k < recorded.held_s.size(); ++k) {
    const std::vector<SampleFrame> frames = store.readRawSamples(k);
    ASSERT_FALSE(frames.empty());
    EXPECT_GE(frames.front().time_s, recorded.held_s[k].first) << "pose " << k + 1;
    EXPECT_LE(frames.back().time_s, recorded.held_s[k].second) << "pose " << k + 1;
    for (const GravitySample& sample : session.poses()[k].capture->samples) {
      EXPECT_NEAR(sample.count, recorded.samples, recorded.samples / 5) << "pose " << k + 1;
    }
  }
  for (const std::string& text : recorded.says) EXPECT_THAT(outcome.err, HasSubstr(text));
  for (const std::string& text : recorded.does_not_say) EXPECT_THAT(outcome.err, Not(HasSubstr(text)));
}

INSTANTIATE_TEST_SUITE_P(Recordings, CaptureOfARecording,
                         ::testing::Values(laidByHand("by hand", "32768 4070", 75),
                                           laidByHand("at half the rate, of another gain", "32768 4522 2", 38),
                                           legOfARobot("readings_20hz.jsonl", true),
                                           legOfARobot("readings_20hz_quiet_model.jsonl", false),
                                           legOfARobot("port_frames_100hz.jsonl", true)));

}  // namespace
}  // namespace hexoderm
