// Hours of work in minutes: a simulated skin streams as fast as it can and is turned every few seconds, every pose is
// captured and stored with its raw samples, and every so many poses a new session file is begun. Fails if poses stop
// coming, if a file is not whole, or if the memory of the process still grows after it has warmed up.
//   soak [--minutes N] [--growth-mib M]      simulated minutes; 0 MiB: memory is not judged (sanitizers keep some)

#include "hexoderm/base/units.h"
#include "hexoderm/capture/pose_recorder.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/session/session_recorder.h"
#include "hexoderm/sim/simulated_source.h"
#include "tests/support/normal_draw.h"
#include "tests/support/temporary_folder.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

using namespace hexoderm;

constexpr std::size_t kPosesPerFile = 40;
/// A turn takes a few seconds, and a pose one more.
constexpr double kPatience_s = 60;

double residentMib() {
  std::ifstream statm("/proc/self/statm");
  double total = 0;
  double resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

/// The soak's results; filled on the source's thread, read when it is over.
struct Account {
  double simulated_s = 0;
  std::size_t frames = 0;
  std::size_t poses = 0;
  std::size_t files = 0;
  double warm_mib = 0;  ///< most that was used while it warmed up
  double most_mib = 0;  ///< most after that
  std::string failure;
};

class Operator final : public SkinListener, public PoseRecorderListener {
 public:
  Operator(SkinSource& source, double duration_s) : source_(source), duration_s_(duration_s), recorder_(*this, raw()) {}

  /// Until the time is over or something fails.
  void wait() const { over_.wait(false); }
  /// After the source was stopped.
  Account finish() {
    if (account_.failure.empty()) endFile();
    return account_;
  }

  void onSkin(const SkinDescription& skin) override {
    skin_ = skin;
    recorder_.setSkin(skin);
  }
  void onFrame(const SampleFrame& frame) override {
    if (over_) return;
    ++account_.frames;
    account_.simulated_s = frame.time_s;
    recorder_.addFrame(frame);
    if (frame.time_s - last_pose_s_ > kPatience_s) {
      end("no pose for " + std::to_string(kPatience_s) + " s: " + hold_.english());
    }
    if (frame.time_s >= duration_s_) end("");
  }
  void onStatus(const SourceStatus& /*status*/) override {}
  void onCommandOutcome(const CommandOutcome& outcome) override {
    if (!outcome.done) end("a turn was refused: " + outcome.message.english());
  }

  void onPoseCaptured(CapturedPose captured) override {
    if (captured.pose->samples.size() != skin_.neighbors.size()) return end("a pose without all of its cells");
    if (!store_) beginFile();
    last_pose_s_ = account_.simulated_s;
    ++account_.poses;
    AddPose add{{captured.pose, false}};
    add.raw = std::make_shared<const std::vector<SampleFrame>>(std::move(captured.frames));
    store_->append({add}, {});
    if (++poses_in_file_ == kPosesPerFile) endFile();
    turn();
  }
  void onHold(const HoldStatus& status) override { hold_ = status.message; }
  void onPreview(SkinPreview /*preview*/) override {}

 private:
  static PoseRecorderOptions raw() {
    PoseRecorderOptions options;
    options.keep_frames = true;
    return options;
  }

  void beginFile() {
    path_ = folder_.path() / ("soak" + std::to_string(account_.files) + ".hexo");
    const Session session(*skin_.model, skin_.neighbors, {skin_.device, "", ""});
    store_ = std::make_unique<SessionRecorder>(SessionStore::create(path_, session));
    poses_in_file_ = 0;
  }

  /// The file holds what was captured; it goes away, and what was captured is forgotten.
  void endFile() {
    if (!store_) return;
    store_.reset();
    const SessionStore stored = SessionStore::openReadOnly(path_);
    const std::size_t found = stored.readSession().poses().size();
    if (found != poses_in_file_) {
      return end("a file of " + std::to_string(poses_in_file_) + " poses, found " + std::to_string(found));
    }
    if (stored.readRawSamples(found - 1).empty()) return end("raw samples in the file");
    std::filesystem::remove(path_);
    ++account_.files;
    recorder_.setEarlierPoses({});
    recorder_.setNextPoseId(PoseId(1));
    lookAtMemory();
  }

  void lookAtMemory() {
    constexpr double kWarmUp = 0.2;  // share of the time, but at least the first file
    double& most =
        account_.simulated_s < kWarmUp * duration_s_ || account_.files < 2 ? account_.warm_mib : account_.most_mib;
    most = std::max(most, residentMib());
  }

  void turn() {
    // Far enough to be another pose.
    constexpr double kAtLeast_rad = 20 * kDegree;
    const Eigen::Vector3d last = up_;
    while (angleBetween(up_, last) < kAtLeast_rad) up_ = random_.direction();
    source_.send(TurnTo{CellId(1), up_});
  }

  void end(const std::string& failure) {
    if (account_.failure.empty()) account_.failure = failure;
    over_ = true;
    over_.notify_one();
  }

  SkinSource& source_;
  double duration_s_;
  SkinDescription skin_;
  test::TemporaryFolder folder_;
  std::filesystem::path path_;
  std::unique_ptr<SessionRecorder> store_;
  std::size_t poses_in_file_ = 0;
  double last_pose_s_ = 0;
  Message hold_;  ///< why no pose is taken
  test::NormalDraw random_{1};
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ();  ///< as asked for last
  Account account_;
  std::atomic<bool> over_ = false;
  PoseRecorder recorder_;
};

int soak(double minutes, double growth_mib) {
  const auto source = openSkinSource("sim:x17?seed=1&speed=max");
  Operator at_work(*source, minutes * 60);
  source->start(at_work);
  at_work.wait();
  source->stop();
  const Account account = at_work.finish();
  std::cout << account.simulated_s / 60 << " simulated minutes: " << account.frames << " frames, " << account.poses
            << " poses, " << account.files << " files; at most " << account.warm_mib << " MiB while warming up, "
            << account.most_mib << " MiB after that\n";
  std::string failure = account.failure;
  if (failure.empty() && account.most_mib == 0) failure = "too short: expected files after the warm-up";
  if (failure.empty() && growth_mib > 0 && account.most_mib > account.warm_mib + growth_mib) {
    failure = "memory grew by more than " + std::to_string(growth_mib) + " MiB";
  }
  if (!failure.empty()) {
    std::cerr << "soak: " << failure << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

}  // namespace

int main(int argc, char** argv) {
  addSimulatedSources();
  double minutes = 5;
  double growth_mib = 4;
  CLI::App app("A simulated skin that streams for hours, compressed", "soak");
  app.add_option("--minutes", minutes, "Simulated minutes, at most a day")->check(CLI::Range(0.1, 24.0 * 60));
  app.add_option("--growth-mib", growth_mib, "0: memory is not judged")->check(CLI::NonNegativeNumber);
  CLI11_PARSE(app, argc, argv)
  return soak(minutes, growth_mib);
}
