#include "hexoderm/device/simulation/simulated_source.h"

#include "hexoderm/device/simulation/patch_plan.h"
#include "hexoderm/device/simulation/robot_in_words.h"
#include "hexoderm/device/simulation/simulated_skin.h"
#include "hexoderm/geometry/surface.h"
#include "hexoderm/kinematics/demo_robot.h"
#include "hexoderm/util/error.h"
#include "hexoderm/util/text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace hexoderm {

struct SimulatedSource::Impl {
  using Clock = std::chrono::steady_clock;
  static constexpr double kWakeEvery_s = 0.01;
  struct Queued {
    std::uint32_t number = 0;
    SkinCommand command;
  };

  std::unique_ptr<SimulatedBody> body;
  double speed;
  std::string address;
  const std::uint64_t ticks_at_once;
  JointReporting joint_reporting;
  SkinListener* listener = nullptr;
  SourceStatus status;

  std::mutex mutex;
  std::condition_variable_any changed;
  std::vector<Queued> queue;
  std::uint32_t last_number = 0;
  std::uint32_t turn_number = 0;  ///< number of the turn that is under way; 0: none

  std::jthread thread;  // last: it uses all of the above

  Impl(std::unique_ptr<SimulatedBody> simulated, double times, std::string text)
      : body(std::move(simulated)),
        speed(times),
        address(std::move(text)),
        ticks_at_once(std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kWakeEvery_s * body->rate_hz()))) {
    if (!(speed > 0)) throw InvalidArgument(message("source \"{}\": speed must be above 0", address));
  }

  void say(SourceState state, Message words) {
    status.state = state;
    status.message = std::move(words);
    listener->onStatus(status);
  }

  void answer(std::uint32_t number, bool done, Message why = {}) {
    listener->onCommandOutcome({number, done, std::move(why)});
  }

  /// Throws InvalidArgument for what can't be done.
  void obey(const Queued& queued) {
    if (const auto* turn = std::get_if<TurnTo>(&queued.command)) {
      if (!body->turnsOnRequest()) throw InvalidArgument(message("the simulated robot turns by itself"));
      body->turnTo(turn->cell, turn->up_u);
      if (turn_number != 0) answer(turn_number, false, message("another turn came before it was there"));
      turn_number = queued.number;
    } else if (const auto* led = std::get_if<SetLed>(&queued.command)) {
      body->requireCell(led->cell);
      answer(queued.number, true);
    } else {
      throw InvalidArgument(message("a simulated skin has the rate of its cell model"));
    }
  }

  void obeyAll() {
    std::vector<Queued> commands;
    {
      const std::lock_guard lock(mutex);
      commands.swap(queue);
    }
    for (const Queued& command : commands) {
      try {
        obey(command);
      } catch (const InvalidArgument& error) {
        answer(command.number, false, error.message());
      }
    }
    if (turn_number != 0 && !body->turning()) answer(std::exchange(turn_number, 0), true);
  }

  void run(const std::stop_token& stop) {
    constexpr std::uint64_t kTicksPerStatus = 500;
    constexpr std::chrono::milliseconds kStatusEvery(500);  // or so, as from any device
    SkinDescription description;
    description.device = body->description();
    description.model = std::make_shared<const CellModel>(body->model());
    description.neighbors = body->neighbors();
    description.can_light_cells = true;
    description.can_turn = body->turnsOnRequest();
    description.truth = std::make_shared<const GroundTruth>(body->groundTruth());
    listener->onSkin(description);
    say(SourceState::Streaming, message("Streaming: {}", description.device));
    const Clock::time_point start = Clock::now();
    const double tick_s = 1 / (body->rate_hz() * speed);
    Clock::time_point reported = start;
    while (!stop.stop_requested()) {
      obeyAll();
      for (std::uint64_t k = 0; k < ticks_at_once; ++k) {
        const double time_s = static_cast<double>(status.frames) / body->rate_hz();
        const std::optional<JointReport> joints = joint_reporting.before(*body, time_s);
        if (joints) listener->onJoints(*joints);
        listener->onFrame(body->next());
        ++status.frames;
        const Clock::time_point now = Clock::now();
        if (status.frames % kTicksPerStatus != 0 && now - reported < kStatusEvery) continue;
        reported = now;
        listener->onStatus(status);
      }
      if (!std::isfinite(speed)) continue;
      const auto due = start + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(static_cast<double>(status.frames) * tick_s));
      std::unique_lock lock(mutex);
      changed.wait_until(lock, stop, due, [] { return false; });
    }
    say(SourceState::Stopped, message("Stopped"));
  }
};

SimulatedSource::SimulatedSource(std::unique_ptr<SimulatedBody> body, double speed, std::string address)
    : impl_(std::make_unique<Impl>(std::move(body), speed, std::move(address))) {}
SimulatedSource::~SimulatedSource() { stop(); }

namespace {

constexpr std::string_view kRobotAddress = "robot";

struct SimulatedAddress {
  std::variant<SimulatedSkinOptions, RobotInWords> body;
  double speed = 1;
};

/// NAME=VALUE, of an address.
struct AddressOption {
  std::string text;
  std::string name;
  std::string value;
};

std::vector<AddressOption> optionsInAddress(const std::string& text) {
  std::vector<AddressOption> options;
  for (const std::string& part : split(text, '&')) {
    const std::size_t equals = part.find('=');
    options.push_back({part, part.substr(0, equals), equals == std::string::npos ? "" : part.substr(equals + 1)});
  }
  return options;
}

SimulatedSkinOptions skinInAddress(const std::string& address, const std::string& patch,
                                   const std::vector<AddressOption>& parts) {
  // Whoever moves the part comes first: it is a whole set of options.
  const auto moves = [](const AddressOption& part) { return part.name == "motion" && part.value == "robot"; };
  SimulatedSkinOptions options =
      std::ranges::any_of(parts, moves) ? SimulatedSkinOptions::robot() : SimulatedSkinOptions();
  options.patch = patch;
  for (const auto& [text, name, value] : parts) {
    if (name == "surface") {
      options.surface = value;
    } else if (name == "seed") {
      options.seed = parseUnsigned(value, "source \"" + address + "\": seed");
    } else if (name != "speed" && (name != "motion" || (value != "hand" && value != "robot"))) {
      throw InvalidArgument(
          message("source \"{}\": expected sim:PATCH[?surface=...&seed=N&speed=X|max&motion=hand|robot], found \"{}\"",
                  address, text));
    }
  }
  return options;
}

RobotInWords robotInAddress(const std::string& address, const std::vector<AddressOption>& parts) {
  RobotInWords robot;
  robot.robot = kDemoRobotName;
  for (const auto& [text, name, value] : parts) {
    if (name == "urdf") {
      robot.robot = value;
    } else if (name == "package") {
      robot.packages.push_back(value);
    } else if (name == "mount") {
      robot.mounts.push_back(value);
    } else if (name == "base") {
      robot.base = value;
    } else if (name == "patch") {
      robot.patch = value;
    } else if (name == "surface") {
      robot.surface = value;
    } else if (name == "seed") {
      robot.seed = parseUnsigned(value, "source \"" + address + "\": seed");
    } else if (name != "speed") {
      throw InvalidArgument(
          message("source \"{}\": expected sim:robot[?urdf=FILE&package=NAME=FOLDER&mount=LINK:X,Y,Z&"
                  "base=fixed|motors|hand&patch=...&surface=...&seed=N&speed=X|max], found \"{}\"",
                  address, text));
    }
  }
  return robot;
}

SimulatedAddress parseAddress(const std::string& address) {
  constexpr std::string_view kPrefix = "sim:";
  const std::size_t query = address.find('?');
  const std::string name = address.substr(kPrefix.size(), query == std::string::npos ? query : query - kPrefix.size());
  std::vector<AddressOption> options;
  if (query != std::string::npos) options = optionsInAddress(address.substr(query + 1));
  SimulatedAddress parsed;
  if (name == kRobotAddress) {
    parsed.body = robotInAddress(address, options);
  } else {
    parsed.body = skinInAddress(address, name, options);
  }
  for (const AddressOption& option : options) {
    if (option.name != "speed") continue;
    parsed.speed = option.value == "max" ? std::numeric_limits<double>::infinity()
                                         : parseNumber(option.value, "source \"" + address + "\": speed");
  }
  if (!(parsed.speed > 0)) throw InvalidArgument(message("source \"{}\": speed must be above 0", address));
  return parsed;
}

std::unique_ptr<SimulatedBody> makeBody(const SimulatedSkinOptions& skin) {
  parseLivePatch(skin.patch);
  return std::make_unique<SimulatedSkin>(builtInCellModel("hex-bma150"), skin);
}
std::unique_ptr<SimulatedBody> makeBody(const RobotInWords& robot) {
  return std::make_unique<SimulatedRobot>(makeRobot(builtInCellModel("hex-bma150"), robot));
}

/// Throws as makeBody() does for what is wrong with the words themselves.
void checkBody(const SimulatedSkinOptions& skin) {
  parseLivePatch(skin.patch);
  if (!skin.surface.empty()) makeSurface(skin.surface);
}
void checkBody(const RobotInWords& robot) { robotOptions(robot); }

}  // namespace

std::unique_ptr<SkinSource> SimulatedSource::open(const std::string& address) {
  const SimulatedAddress parsed = parseAddress(address);
  std::unique_ptr<SimulatedBody> body = std::visit([](const auto& what) { return makeBody(what); }, parsed.body);
  return std::make_unique<SimulatedSource>(std::move(body), parsed.speed, address);
}

void SimulatedSource::check(const std::string& address) {
  std::visit([](const auto& what) { checkBody(what); }, parseAddress(address).body);
}

void SimulatedSource::start(SkinListener& listener) {
  impl_->listener = &listener;
  impl_->thread = std::jthread([impl = impl_.get()](const std::stop_token& stop) { impl->run(stop); });
}

void SimulatedSource::stop() noexcept {
  if (!impl_->thread.joinable()) return;
  impl_->thread.request_stop();
  impl_->thread.join();
}

std::uint32_t SimulatedSource::send(const SkinCommand& command) {
  const std::lock_guard lock(impl_->mutex);
  impl_->queue.push_back({++impl_->last_number, command});
  return impl_->last_number;
}

std::string SimulatedSource::address() const { return impl_->address; }

}  // namespace hexoderm
