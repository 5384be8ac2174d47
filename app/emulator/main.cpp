#include "app/emulator/emulator.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/interrupt.h"
#include "hexoderm/base/text.h"
#include "hexoderm/sim/fault_names.h"
#include "hexoderm/sim/robot_text.h"
#include "hexoderm/sim/simulated_skin.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <CLI/CLI.hpp>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>
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

/// The list of lines that can be typed while the emulator runs.
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

/// Does one line, and returns what to say about it; empty for an empty line. Throws InvalidArgument for what can't be
/// understood or done.
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

// The exit codes of hexoderm-cli, as far as they apply.
constexpr int kDone = 0;
constexpr int kUsage = 2;
constexpr int kBadInput = 3;
constexpr int kDevice = 4;

struct Options {
  RobotText words;
  std::string cell_model = "hex-bma150";
  std::string link_law = "bend";
  double offset_sigma_mg = -1;
  std::vector<std::string> faults;
  std::optional<std::uint16_t> tcp_port;
  std::optional<std::uint16_t> udp_port;
  bool pty = false;
  std::string bind = "127.0.0.1";
  bool json = false;
  EmulatedDeviceOptions device;
  double speed = 1;
};

void addOptions(CLI::App& app, Options& options) {
  CLI::Option_group* wire = app.add_option_group("Wire", "One of them");
  CLI::Option* tcp = wire->add_option("--tcp", options.tcp_port, "Listen on this TCP port; 0: any that is free");
  wire->add_option("--udp", options.udp_port, "Listen on this UDP port; 0: any that is free");
  wire->add_flag("--pty", options.pty, "Make a pseudo-terminal, which a host opens as a serial port");
  wire->require_option(1);
  app.add_option("--bind", options.bind, "Address to listen on; 0.0.0.0: reachable from other computers")
      ->capture_default_str();
  app.add_flag("--json", options.json, "Speak lines of JSON instead of frames of bytes")->needs(tcp);

  app.add_option("--patch", options.words.patch,
                 "x17, ringN, ringN:closed or sheet:ROWSxCOLS (the paper's 31 cells: ring31:closed)")
      ->capture_default_str();
  app.add_option("--surface", options.words.surface,
                 "plane, cylinder:r=M, sphere:r=M, cone:r=M,angle=RAD or torus:R=M,r=M "
                 "(default: what suits the patch)");
  app.add_option("--link-law", options.link_law, "How the mould lets neighbours lie: bend or surface")
      ->check(CLI::IsMember({"bend", "surface"}))
      ->capture_default_str();
  app.add_option("--seed", options.words.seed, "Seed of everything random")->capture_default_str();
  app.add_option("--cell-model", options.cell_model, "Built-in name or JSON file")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--offset-sigma", options.offset_sigma_mg,
                 "Offset of each accelerometer beside its lot's, 1 sigma, in mg (default: the cell model's)")
      ->check(CLI::NonNegativeNumber);
  CLI::Option* ideal = app.add_flag("--ideal", options.words.ideal, "No jitter, no sensor errors, no noise, no hand");
  app.add_option("--fault", options.faults, faultSyntax() + "; may be repeated");

  CLI::Option* robot =
      app.add_option(
             "--robot", options.words.robot,
             "A robot that wears the skin, as URDF, or demo: an arm with a patch on the upper arm and one on the "
             "forearm. It moves its joints when it is asked to turn, and says where they stand")
          ->type_name("FILE");
  app.add_option("--mount", options.words.mounts,
                 "A patch on the robot: " + std::string(kMountSyntax) +
                     ", the place of its middle in the link's frame in m and rad, z out of the skin; without --surface "
                     "it lies on the link's body where that is nearest; may be repeated")
      ->needs(robot);
  app.add_option("--base", options.words.base,
                 "What holds the robot: fixed, on a base that holds still; motors, the same with its motors on, which "
                 "shake it by 8 to 35 mg; or hand, which turns the whole robot")
      ->check(CLI::IsMember({"fixed", "motors", "hand"}))
      ->capture_default_str()
      ->needs(robot)
      ->excludes(ideal);
  app.add_option("--package", options.words.packages, "NAME=FOLDER of meshes at package://NAME/...; may be repeated")
      ->needs(robot);

  app.add_option("--rate", options.device.rate_hz, "Samples of each cell per second (default: the cell model's)")
      ->check(CLI::PositiveNumber);
  app.add_option("--means", options.device.means_of, "Cells average so many samples by themselves (default: none)");
  app.add_option("--speed", options.speed, "How much faster than real time everything goes")
      ->check(CLI::Range(0.01, 1000.0))
      ->capture_default_str();
}

std::unique_ptr<SimulatedBody> bodyOf(const Options& options) {
  CellModel model = loadCellModel(options.cell_model);
  if (options.offset_sigma_mg >= 0) model.accelerometer.offset_sigma_g.setConstant(options.offset_sigma_mg / 1000);
  RobotText words = options.words;
  words.link_law = linkLawFromName(options.link_law);
  for (const std::string& fault : options.faults) addFault(fault, "--fault", words);
  return makeBody(std::move(model), words);
}

std::unique_ptr<DeviceLink> openLink(boost::asio::io_context& io, const Options& options) {
  if (options.tcp_port) {
    return listenTcp(io, options.bind, *options.tcp_port,
                     options.json ? skinwire::Framing::Lines : skinwire::Framing::Length);
  }
  if (options.udp_port) return listenUdp(io, options.bind, *options.udp_port);
  return openPseudoTerminal(io);
}

/// Reads lines of standard input on a thread of its own. Not by Asio: it would make the descriptor non-blocking for
/// every program that shares the terminal.
class LineReader {
 public:
  /// `take` is called on the reader's thread. The end of the input is no reason to end.
  explicit LineReader(std::function<void(std::string)> take) : take_(std::move(take)) {
    if (::pipe2(wake_.data(), O_CLOEXEC) != 0) throw DeviceError("standard input can't be read: no pipe");
    thread_ = std::thread([this] { run(); });
  }
  ~LineReader() {
    const char byte = 0;
    [[maybe_unused]] const ssize_t written = ::write(wake_[1], &byte, 1);
    thread_.join();
    for (const int end : wake_) ::close(end);
  }
  LineReader(const LineReader&) = delete;
  LineReader& operator=(const LineReader&) = delete;

 private:
  void run() {
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

  std::function<void(std::string)> take_;
  std::array<int, 2> wake_{-1, -1};
  std::thread thread_;
};

/// Asks now and then: the handler of a signal can't do more than raise a flag.
class InterruptWatch {
 public:
  InterruptWatch(boost::asio::io_context& io, Emulator& emulator) : timer_(io), emulator_(emulator) { ask(); }

 private:
  void ask() {
    if (isInterrupted()) return emulator_.stop();
    timer_.expires_after(std::chrono::milliseconds(50));
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (!error) ask();
    });
  }

  boost::asio::steady_timer timer_;
  Emulator& emulator_;
};

void run(Options options) {
  boost::asio::io_context io(1);
  std::unique_ptr<DeviceLink> link = openLink(io, options);
  options.device.max_body = link->maxBody();
  options.device.exploration.seed = options.words.seed;
  // The host's patience is of the wall's clock, the device's is its own.
  options.device.status_every_s *= options.speed;
  options.device.working_every_s *= options.speed;
  options.device.message_every_s *= options.speed;
  const std::string address = link->address();
  EmulatedDevice device(bodyOf(options), options.device);
  const Exploration& exploration = device.exploration();
  std::cout << "listening on " << address << '\n'
            << device.body().description() << ": " << device.body().neighbors().size()
            << " cells; exploring takes them " << std::lround(1000 * exploration.duration_s) << " ms and "
            << exploration.messages << " messages" << std::endl;

  Emulator emulator(io, std::move(device), std::move(link), options.speed);
  endOnInterrupt("hexoderm-emulator: ended while something was held up\n");
  const InterruptWatch watch(io, emulator);
  const LineReader reader([&](const std::string& line) {
    boost::asio::post(io, [&, line] {
      try {
        const std::string text = runLine(line, emulator);
        if (!text.empty()) std::cout << text << std::endl;
      } catch (const Error& error) {
        std::cout << "error: " << forTerminal(error.what()) << std::endl;
      }
    });
  });
  emulator.start();
  io.run();
}

int fail(const std::exception& error, int code) {
  std::cerr << "hexoderm-emulator: " << forTerminal(error.what()) << '\n';
  return code;
}

}  // namespace
}  // namespace hexoderm::emulator

int main(int argc, char** argv) {
  using namespace hexoderm;
  namespace emulator = hexoderm::emulator;
  std::signal(SIGPIPE, SIG_IGN);
  emulator::Options options;
  CLI::App app("A simulated skin that behaves as a device: on TCP, UDP or a pseudo-terminal, speaking SkinWire",
               "hexoderm-emulator");
  app.set_version_flag("--version", "hexoderm-emulator " HEXODERM_VERSION);
  emulator::addOptions(app, options);
  app.footer(emulator::consoleHelp());
  try {
    app.parse(argc, argv);
    emulator::run(options);
    return emulator::kDone;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? emulator::kDone : emulator::kUsage;
  } catch (const DeviceError& error) {
    return emulator::fail(error, emulator::kDevice);
  } catch (const InvalidArgument& error) {
    return emulator::fail(error, emulator::kUsage);
  } catch (const Error& error) {
    return emulator::fail(error, emulator::kBadInput);
  } catch (const std::bad_alloc& error) {
    return emulator::fail(error, emulator::kDevice);
  }
}
