#include "hexoderm/sim/simulated_source.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/surface.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/sources/open_source.h"
#include "hexoderm/device/sources/threaded_source.h"
#include "hexoderm/robots/demo_robot.h"
#include "hexoderm/sim/patch_plan.h"
#include "hexoderm/sim/robot_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace hexoderm {
namespace {

class SimulatedSource final : public ThreadedSource<> {
 public:
  SimulatedSource(std::unique_ptr<SimulatedBody> body, double speed, const std::string& address)
      : ThreadedSource(address),
        body_(std::move(body)),
        speed_(speed),
        ticks_at_once_(std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kWakeEvery_s * body_->rate_hz()))) {}
  ~SimulatedSource() override { stop(); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kWakeEvery_s = 0.01;

  void say(SourceState state, Message words) {
    status_.state = state;
    status_.message = std::move(words);
    listener_->onStatus(status_);
  }

  void answer(std::uint32_t number, bool done, Message why = {}) {
    listener_->onCommandOutcome({number, done, std::move(why)});
  }

  /// Throws InvalidArgument for what can't be done.
  void obey(const Queued& queued) {
    if (const auto* turn = std::get_if<TurnTo>(&queued.command)) {
      if (!body_->turnsOnRequest()) throw InvalidArgument(message("the simulated robot turns by itself"));
      body_->turnTo(turn->cell, turn->up_u);
      if (turn_number_ != 0) answer(turn_number_, false, message("another turn came before it was there"));
      turn_number_ = queued.number;
    } else if (const auto* led = std::get_if<SetLed>(&queued.command)) {
      body_->requireCell(led->cell);
      answer(queued.number, true);
    } else {
      throw InvalidArgument(message("a simulated skin has the rate of its cell model"));
    }
  }

  void obeyAll() {
    for (const Queued& command : takeCommands()) {
      try {
        obey(command);
      } catch (const InvalidArgument& error) {
        answer(command.number, false, error.message());
      }
    }
    if (turn_number_ != 0 && !body_->turning()) answer(std::exchange(turn_number_, 0), true);
  }

  void run() override {
    constexpr std::uint64_t kTicksPerStatus = 500;
    constexpr std::chrono::milliseconds kStatusEvery(500);  // or so, as from any device
    SkinDescription description;
    description.device = body_->description();
    description.model = std::make_shared<const CellModel>(body_->model());
    description.neighbors = body_->neighbors();
    description.can_light_cells = true;
    description.can_turn = body_->turnsOnRequest();
    description.truth = std::make_shared<const GroundTruth>(body_->groundTruth());
    listener_->onSkin(description);
    say(SourceState::Streaming, message("Streaming: {}", description.device));
    const Clock::time_point start = Clock::now();
    const double tick_s = 1 / (body_->rate_hz() * speed_);
    Clock::time_point reported = start;
    while (!stop_.stop_requested()) {
      obeyAll();
      for (std::uint64_t k = 0; k < ticks_at_once_; ++k) {
        const double time_s = static_cast<double>(status_.frames) / body_->rate_hz();
        const std::optional<JointReport> joints = joint_reporting_.before(*body_, time_s);
        if (joints) listener_->onJoints(*joints);
        listener_->onFrame(body_->next());
        ++status_.frames;
        const Clock::time_point now = Clock::now();
        if (status_.frames % kTicksPerStatus != 0 && now - reported < kStatusEvery) continue;
        reported = now;
        listener_->onStatus(status_);
      }
      if (!std::isfinite(speed_)) continue;
      const auto due = start + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(static_cast<double>(status_.frames) * tick_s));
      std::unique_lock lock(mutex_);
      changed_.wait_until(lock, stop_, due, [] { return false; });
    }
    say(SourceState::Stopped, message("Stopped"));
  }

  std::unique_ptr<SimulatedBody> body_;
  double speed_;
  const std::uint64_t ticks_at_once_;
  JointReporting joint_reporting_;
  SourceStatus status_;
  std::uint32_t turn_number_ = 0;  ///< number of the turn that is under way; 0: none
};

struct SimulatedAddress {
  RobotText words;
  std::string motion = "hand";
  double speed = 1;
};

SimulatedAddress parseAddress(const std::string& address) {
  constexpr std::string_view kPrefix = "sim:";
  const std::size_t query = std::min(address.find('?'), address.size());
  const std::string name = address.substr(kPrefix.size(), query - kPrefix.size());
  const bool is_robot = name == "robot";
  SimulatedAddress parsed;
  RobotText& words = parsed.words;
  std::map<std::string_view, std::string*> texts = {{"surface", &words.surface}};
  std::map<std::string_view, std::vector<std::string>*> lists;
  if (is_robot) {
    words.robot = kDemoRobotName;
    texts.insert({{"urdf", &words.robot}, {"base", &words.base}, {"patch", &words.patch}});
    lists = {{"package", &words.packages}, {"mount", &words.mounts}};
  } else {
    words.patch = name;
    texts.insert({"motion", &parsed.motion});
  }
  const auto within = [&](const char* what) { return "source \"" + address + "\": " + what; };
  const auto take = [&](const std::string& option, const std::string& value) {
    if (const auto text = texts.find(option); text != texts.end()) {
      *text->second = value;
    } else if (const auto list = lists.find(option); list != lists.end()) {
      list->second->push_back(value);
    } else if (option == "seed") {
      words.seed = parseUnsigned(value, within("seed"));
    } else if (option == "speed") {
      parsed.speed = value == "max" ? std::numeric_limits<double>::infinity() : parseNumber(value, within("speed"));
    } else {
      return false;
    }
    return words.robot.empty() != is_robot && (parsed.motion == "hand" || parsed.motion == "robot");
  };
  std::vector<std::string> parts;
  if (query < address.size()) parts = split(address.substr(query + 1), '&');
  for (const std::string& part : parts) {
    const std::size_t equals = std::min(part.find('='), part.size());
    if (take(part.substr(0, equals), part.substr(std::min(equals + 1, part.size())))) continue;
    throw InvalidArgument(
        is_robot ? message("source \"{}\": expected sim:robot[?urdf=FILE&package=NAME=FOLDER&mount=LINK:X,Y,Z&"
                           "base=fixed|motors|hand&patch=...&surface=...&seed=N&speed=X|max], found \"{}\"",
                           address, part)
                 : message("source \"{}\": expected "
                           "sim:PATCH[?surface=...&seed=N&speed=X|max&motion=hand|robot], found \"{}\"",
                           address, part));
  }
  if (!(parsed.speed > 0)) throw InvalidArgument(message("source \"{}\": speed must be above 0", address));
  if (!is_robot) parseLivePatch(words.patch);
  return parsed;
}

std::unique_ptr<SkinSource> openAddress(const std::string& address) {
  const SimulatedAddress parsed = parseAddress(address);
  return std::make_unique<SimulatedSource>(makeBody(builtInCellModel("hex-bma150"), parsed.words, parsed.motion),
                                           parsed.speed, address);
}

/// Builds nothing, however many cells there are. Only building can tell that a patch does not fit its surface.
void checkAddress(const std::string& address) {
  const RobotText words = parseAddress(address).words;
  if (!words.robot.empty()) {
    robotOptions(words);
  } else if (!words.surface.empty()) {
    makeSurface(words.surface);
  }
}

}  // namespace

void addSimulatedSources() {
  addSourceKind({"sim:",
                 "sim:PATCH[?surface=...&seed=N&speed=X|max&motion=hand|robot], "
                 "sim:robot[?urdf=FILE&mount=LINK:X,Y,Z&base=fixed|motors|hand&seed=N&speed=X|max]",
                 openAddress, checkAddress});
}

}  // namespace hexoderm
