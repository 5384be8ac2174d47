// The program that kill_test.py kills: it captures, saves or converts without end, and reports its progress on standard
// output. Everything it writes follows from a number, so that a later reader knows what must be there.
//
//   kill_helper capture FILE.hexo         opens or makes the store and captures; after each acknowledgement a line
//                                         "captured POSE mean... covariance... temperature" with exact numbers
//   kill_helper save FOLDER               writes FOLDER/saved.session.json again and again: "saved SIZE"
//   kill_helper convert FOLDER            makes FOLDER/N.hexo of sessions and FOLDER/back.session.json of those:
//                                         "converted N"
//   kill_helper check FILE                reads a session: "poses N", or an error and exit code 1

#include "hexoderm/base/error.h"
#include "hexoderm/io/open_file.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_recorder.h"

#include <unistd.h>

#include <cinttypes>
#include <cstdio>
#include <future>
#include <string>

namespace hexoderm {
namespace {

constexpr std::uint32_t kCells = 5;

/// One write, so that a line is there whole or not at all.
void say(const std::string& line) {
  if (::write(STDOUT_FILENO, (line + "\n").data(), line.size() + 1) < 0) ::_exit(2);
}

std::string exact(double value) {
  char text[64];
  std::snprintf(text, sizeof(text), " %a", value);
  return text;
}

/// A number between -1 and 1 with all its digits, from two others.
double number(std::uint32_t a, std::uint32_t b) {
  std::uint64_t x = (static_cast<std::uint64_t>(a) << 32U | b) + 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<double>(static_cast<std::int64_t>(x ^ (x >> 31U))) / 9.3e18;
}

SessionPose poseOf(std::uint32_t id, std::uint32_t cells) {
  PoseCapture capture;
  capture.id = PoseId(id);
  capture.taken_at_ms = 1'700'000'000'000 + id;
  for (std::uint32_t cell = 1; cell <= cells; ++cell) {
    GravitySample sample;
    sample.cell = CellId(cell);
    sample.count = 100;
    std::uint32_t k = 100 * cell;
    for (double& value : sample.mean_g) value = number(id, k++);
    sample.cov_g2.diagonal().setConstant(number(id, k) * number(id, k));
    sample.temperature_c = 30 * number(id, ++k);
    capture.samples.push_back(sample);
  }
  return {std::make_shared<const PoseCapture>(std::move(capture))};
}

std::string inWords(const SessionPose& pose) {
  std::string text = std::to_string(pose.capture->id.value());
  for (const GravitySample& sample : pose.capture->samples) {
    for (const double value : sample.mean_g) text += exact(value);
    text += exact(sample.cov_g2(0, 0)) + exact(*sample.temperature_c);
  }
  return text;
}

Session sessionOf(std::uint32_t poses, std::uint32_t cells) {
  Session session(builtInCellModel("hex-bma150"), {{CellId(1), "", {}}},
                  {Message::verbatim("Made to be killed"), "", ""});
  for (std::uint32_t id = 1; id <= poses; ++id) session.addPose(poseOf(id, cells));
  return session;
}

[[noreturn]] void capture(const std::string& file) {
  if (!std::filesystem::exists(file)) writeSessionStore(sessionOf(0, kCells), file);
  SessionStore store = SessionStore::open(file);
  std::uint32_t id = store.readSession().nextPoseId().value();
  SessionRecorder recorder(std::move(store));
  say("opened");
  while (true) {
    const SessionPose pose = poseOf(id++, kCells);
    auto acknowledged = std::make_shared<std::promise<void>>();
    std::vector<StoreOperation> operations;
    operations.emplace_back(AddPose{pose});
    recorder.append(std::move(operations), [acknowledged, pose](const StoreOutcome& outcome) {
      if (!outcome.error.empty()) {
        say("failed " + outcome.error.english());
        ::_exit(1);
      }
      say("captured " + inWords(pose));
      acknowledged->set_value();
    });
    // Two at a time, so that the recorder is killed while something waits as well.
    if (id % 2 == 0) acknowledged->get_future().wait();
  }
}

[[noreturn]] void save(const std::string& folder) {
  const std::uint32_t sizes[] = {3, 40};
  for (std::uint32_t round = 0;; ++round) {
    const std::uint32_t poses = sizes[round % 2];
    writeSessionJson(sessionOf(poses, 50), folder + "/saved.session.json");
    say("saved " + std::to_string(poses));
  }
}

/// One file, to the end.
int write(const std::string& folder) {
  writeSessionJson(sessionOf(1, 1), folder + "/written.session.json");
  return 0;
}

[[noreturn]] void convert(const std::string& folder) {
  for (std::uint32_t n = 1;; ++n) {
    const std::string store = folder + "/" + std::to_string(::getpid()) + "-" + std::to_string(n) + ".hexo";
    writeSessionStore(sessionOf(20, 50), store);
    writeSessionJson(readSessionStore(store), folder + "/back.session.json");
    say("converted " + store);
  }
}

int check(const std::string& file) {
  const OpenedFile opened = openFile(file, builtInCellModel("hex-bma150"));
  const auto& session = std::get<Session>(opened);
  say("poses " + std::to_string(session.poses().size()));
  for (const SessionPose& pose : session.poses()) {
    const auto cells = static_cast<std::uint32_t>(pose.capture->samples.size());
    if (inWords(pose) != inWords(poseOf(pose.capture->id.value(), cells))) {
      say("pose " + std::to_string(pose.capture->id.value()) + " is not as it was captured");
      return 1;
    }
  }
  return 0;
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  using namespace hexoderm;
  if (argc != 3) return 2;
  const std::string what = argv[1];
  try {
    if (what == "capture") capture(argv[2]);
    if (what == "save") save(argv[2]);
    if (what == "convert") convert(argv[2]);
    if (what == "write") return write(argv[2]);
    if (what == "check") return check(argv[2]);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 2;
}
