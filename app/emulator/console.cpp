#include "app/emulator/console.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/sim/fault_names.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace hexoderm::emulator {
namespace {

constexpr EnumNames<PortFaultKind> kPortFaultNames = {{"deaf", "mute", "cut"}};
constexpr std::string_view kNoAnswer = "no-answer";

class Words {
 public:
  explicit Words(const std::string& line) {
    std::istringstream in(line);
    for (std::string word; in >> word;) words_.push_back(word);
  }
  [[nodiscard]] std::size_t size() const { return words_.size(); }
  const std::string& operator[](std::size_t k) const { return words_.at(k); }
  [[nodiscard]] CellId cell(std::size_t k) const { return CellId(parseUnsigned(words_.at(k), "cell")); }
  [[nodiscard]] LinkEnd end(std::size_t k) const {
    return {cell(k), PortNumber(parseUnsigned(words_.at(k + 1), "port"))};
  }
  /// on, off or "20%".
  [[nodiscard]] double share(std::size_t k) const {
    const std::string& word = words_.at(k);
    if (word == "on") return 1;
    if (word == "off") return 0;
    double share = -1;
    if (word.ends_with('%')) share = parseNumber(word.substr(0, word.size() - 1), words_[0]) / 100;
    if (!(share >= 0 && share <= 1)) throw InvalidArgument(words_[0] + ": expected on, off or 0% to 100%");
    return share;
  }
  /// Throws if there are not so many words behind the first.
  void expect(std::size_t least, std::size_t most, const std::string& what) const {
    if (size() < least + 1 || size() > most + 1) throw InvalidArgument("expected " + words_[0] + " " + what);
  }

 private:
  std::vector<std::string> words_;
};

std::string breakIt(const Words& words, Emulator& emulator) {
  words.expect(2, 3, "KIND CELL or KIND CELL PORT");
  EmulatedDevice& device = emulator.device();
  const std::string& kind = words[1];
  if (words.size() == 3) {
    if (kind == kNoAnswer) {
      device.breakController(words.cell(2));
      return "cell " + words[2] + " will not answer when the cells explore again";
    }
    const std::optional<SkinFault> fault = kSkinFaultNames.find(kind);
    if (!fault) {
      throw InvalidArgument("break KIND CELL: expected one of " + inARow(kSkinFaultNames.names) + ", " +
                            std::string(kNoAnswer));
    }
    device.breakCell({*fault, words.cell(2)});
    return "cell " + words[2] + " is broken: " + kind;
  }
  const LinkEnd at = words.end(2);
  if (const std::optional<PortFaultKind> fault = kPortFaultNames.find(kind)) {
    device.breakPort({*fault, at});
    return "cell " + words[2] + ", port " + words[3] + " will be " + kind + " when the cells explore again";
  }
  const std::optional<LinkFaultKind> fault = kLinkFaultNames.find(kind);
  if (!fault) {
    throw InvalidArgument("break KIND CELL PORT: expected one of " + inARow(kLinkFaultNames.names) + ", " +
                          inARow(kPortFaultNames.names));
  }
  emulator.withDevice([&](EmulatedDevice::Messages& out) { device.breakLink({*fault, at}, out); });
  return "the device starts again with a broken link at cell " + words[2] + ", port " + words[3] + ": " + kind;
}

std::string mendIt(const Words& words, Emulator& emulator) {
  words.expect(1, 2, "CELL or CELL PORT");
  EmulatedDevice& device = emulator.device();
  if (words.size() == 2) {
    device.mendCell(words.cell(1));
    return "cell " + words[1] + " is whole";
  }
  const LinkEnd at = words.end(1);
  bool was_broken = device.mendPort(at);
  emulator.withDevice([&](EmulatedDevice::Messages& out) { was_broken = device.mendLink(at, out) || was_broken; });
  if (!was_broken) throw InvalidArgument("nothing was broken at cell " + words[1] + ", port " + words[2]);
  return "cell " + words[1] + ", port " + words[2] + " is whole";
}

std::string statusOf(Emulator& emulator) {
  const EmulatedDevice& device = emulator.device();
  const skinwire::Status status = device.status();
  const Exploration& exploration = device.exploration();
  return (status.exploring ? "exploring"
                           : std::to_string(exploration.cells.size()) + " cells explored in " +
                                 formatFixed(1000 * exploration.duration_s, 1) + " ms with " +
                                 std::to_string(exploration.messages) + " messages") +
         "; samples sent " + std::to_string(status.samples_sent) + ", dropped " +
         std::to_string(status.samples_dropped);
}

std::string ledOf(const Words& words, Emulator& emulator) {
  words.expect(1, 1, "CELL");
  std::ostringstream text;
  text << "cell " << words[1] << " #" << std::hex << std::setfill('0');
  for (const std::uint8_t colour : emulator.device().led(words.cell(1))) text << std::setw(2) << unsigned{colour};
  return text.str();
}

std::string turnIt(const Words& words, Emulator& emulator) {
  words.expect(3, 3, "X Y Z");
  const Eigen::Vector3d up_b(parseNumber(words[1], "turn X"), parseNumber(words[2], "turn Y"),
                             parseNumber(words[3], "turn Z"));
  emulator.withDevice([&](EmulatedDevice::Messages& out) { emulator.device().turnTo(up_b, out); });
  return "turning";
}

}  // namespace

std::string consoleHelp() {
  return "While it runs, on standard input:\n"
         "  break KIND CELL        " +
         inARow(kSkinFaultNames.names) + ", " + std::string(kNoAnswer) +
         "\n"
         "  break KIND CELL PORT   " +
         inARow(kLinkFaultNames.names) + " (the device starts again), " + inARow(kPortFaultNames.names) +
         "\n"
         "  mend CELL [PORT]\n"
         "  explore                the cells explore their neighbours again\n"
         "  turn X Y Z             until this direction of the body (of a robot in a hand: its base) points up\n"
         "  pose                   turns to the next pose; a robot's joints go to angles drawn at random\n"
         "  drop on|off|20%        messages of samples get lost on the wire\n"
         "  garble on|off|20%      a bit of a message is flipped\n"
         "  silence on|off         nothing is sent at all\n"
         "  disconnect             takes leave of the host\n"
         "  led CELL, status, help, quit";
}

std::string runLine(const std::string& line, Emulator& emulator) {
  const Words words(line);
  if (words.size() == 0) return "";
  const std::string& verb = words[0];
  const auto alone = [&] { words.expect(0, 0, "without anything behind"); };
  const auto onOff = [&](double& share) {
    words.expect(1, 1, "on, off or 20%");
    share = words.share(1);
    return verb + " " + words[1];
  };
  if (verb == "break") return breakIt(words, emulator);
  if (verb == "mend") return mendIt(words, emulator);
  if (verb == "drop") return onOff(emulator.faults().drop_share);
  if (verb == "garble") return onOff(emulator.faults().garble_share);
  if (verb == "silence") {
    words.expect(1, 1, "on or off");
    if (words[1] != "on" && words[1] != "off") throw InvalidArgument("silence: expected on or off");
    emulator.faults().is_silent = words[1] == "on";
    return "silence " + words[1];
  }
  if (verb == "turn") return turnIt(words, emulator);
  if (verb == "led") return ledOf(words, emulator);
  alone();
  if (verb == "status") return statusOf(emulator);
  if (verb == "help") return consoleHelp();
  if (verb == "explore") {
    emulator.withDevice([&](EmulatedDevice::Messages& out) { emulator.device().exploreAgain(out); });
    return "exploring";
  }
  if (verb == "pose") {
    emulator.withDevice([&](EmulatedDevice::Messages& out) { emulator.device().turnToNextPose(out); });
    return "turning";
  }
  if (verb == "disconnect") {
    emulator.disconnect();
    return "disconnected";
  }
  if (verb == "quit") {
    emulator.stop();
    return "bye";
  }
  throw InvalidArgument("\"" + verb + "\" is not known; \"help\" lists what is");
}

LineReader::LineReader(std::function<void(std::string)> take) : take_(std::move(take)) {
  if (::pipe2(wake_.data(), O_CLOEXEC) != 0) throw DeviceError("standard input can't be read: no pipe");
  thread_ = std::thread([this] { run(); });
}

LineReader::~LineReader() {
  const char byte = 0;
  [[maybe_unused]] const ssize_t written = ::write(wake_[1], &byte, 1);
  thread_.join();
  for (const int end : wake_) ::close(end);
}

void LineReader::run() {
  std::string text;
  std::array<char, 4096> buffer{};
  while (true) {
    std::array<pollfd, 2> ends = {{{STDIN_FILENO, POLLIN, 0}, {wake_[0], POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) return;
    if (ends[1].revents != 0) return;
    if (ends[0].revents == 0) continue;
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return;
    text.append(buffer.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos; text.erase(0, end + 1)) {
      take_(text.substr(0, end));
    }
    if (text.size() > buffer.size()) text.clear();
  }
}

}  // namespace hexoderm::emulator
