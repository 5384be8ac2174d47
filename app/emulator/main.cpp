#include "app/emulator/console.h"
#include "hexoderm/base/error.h"
#include "hexoderm/base/interrupt.h"
#include "hexoderm/base/text.h"
#include "hexoderm/sim/fault_names.h"
#include "hexoderm/sim/robot_text.h"
#include "hexoderm/sim/simulated_skin.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include <CLI/CLI.hpp>

#include <cmath>
#include <csignal>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace hexoderm::emulator {
namespace {

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
                 "Accelerometer offsets, 1 sigma, in mg (default: the cell model's)")
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
  if (options.offset_sigma_mg >= 0) model.accelerometer.offset_sigma_g = options.offset_sigma_mg / 1000;
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
