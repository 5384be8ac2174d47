#include "hexoderm/device/simulation/simulated_source.h"

#include "hexoderm/device/simulation/patch_plan.h"
#include "hexoderm/geometry/surface.h"
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
#include <vector>

namespace hexoderm {

struct SimulatedSource::Impl {
  using Clock = std::chrono::steady_clock;
  static constexpr double kWakeEvery_s = 0.01;
  struct Queued {
    std::uint32_t number = 0;
    SkinCommand command;
  };

  SimulatedSkin skin;
  double speed;
  std::string address;
  const std::uint64_t ticks_at_once;
  SkinListener* listener = nullptr;
  SourceStatus status;

  std::mutex mutex;
  std::condition_variable_any changed;
  std::vector<Queued> queue;
  std::uint32_t last_number = 0;
  std::uint32_t turn_number = 0;  ///< number of the turn that is under way; 0: none

  std::jthread thread;  // last: it uses all of the above

  Impl(SimulatedSkin simulated, double times, std::string text)
      : skin(std::move(simulated)),
        speed(times),
        address(std::move(text)),
        ticks_at_once(std::max<std::uint64_t>(1, static_cast<std::uint64_t>(kWakeEvery_s * skin.rate_hz()))) {
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

  [[nodiscard]] const TrueCell* find(CellId id) const {
    return id.value() == 0 || id.value() > skin.truth().size() ? nullptr : &skin.truth()[id.value() - 1];
  }

  void obey(const Queued& queued) {
    if (const auto* turn = std::get_if<TurnTo>(&queued.command)) {
      if (skin.options().on_robot) return answer(queued.number, false, message("the simulated robot turns by itself"));
      const TrueCell* cell = find(turn->cell);
      if (cell == nullptr) return answer(queued.number, false, message("there is no cell {}", turn->cell));
      if (!turn->up_u.allFinite() || turn->up_u.norm() < 1e-9) {
        return answer(queued.number, false, message("up must be a finite vector other than zero"));
      }
      if (turn_number != 0) answer(turn_number, false, message("another turn came before it was there"));
      skin.turnTo(cell->T_b_u.R * turn->up_u);
      turn_number = queued.number;
    } else if (const auto* led = std::get_if<SetLed>(&queued.command)) {
      const bool known = find(led->cell) != nullptr;
      answer(queued.number, known, known ? Message() : message("there is no cell {}", led->cell));
    } else {
      answer(queued.number, false, message("a simulated skin has the rate of its cell model"));
    }
  }

  void obeyAll() {
    std::vector<Queued> commands;
    {
      const std::lock_guard lock(mutex);
      commands.swap(queue);
    }
    for (const Queued& command : commands) obey(command);
    if (turn_number != 0 && !skin.turning()) answer(std::exchange(turn_number, 0), true);
  }

  void run(const std::stop_token& stop) {
    constexpr std::uint64_t kTicksPerStatus = 500;
    SkinDescription description;
    description.device = skin.description();
    description.model = std::make_shared<const CellModel>(skin.model());
    description.neighbors = skin.neighbors();
    description.can_light_cells = true;
    description.can_turn = !skin.options().on_robot;
    description.truth = std::make_shared<const GroundTruth>(skin.groundTruth());
    listener->onSkin(description);
    say(SourceState::Streaming, message("Streaming: {}", description.device));
    const Clock::time_point start = Clock::now();
    const double tick_s = 1 / (skin.rate_hz() * speed);
    while (!stop.stop_requested()) {
      obeyAll();
      for (std::uint64_t k = 0; k < ticks_at_once; ++k) {
        listener->onFrame(skin.next());
        if (++status.frames % kTicksPerStatus == 0) listener->onStatus(status);
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

SimulatedSource::SimulatedSource(SimulatedSkin skin, double speed, std::string address)
    : impl_(std::make_unique<Impl>(std::move(skin), speed, std::move(address))) {}
SimulatedSource::~SimulatedSource() { stop(); }

namespace {

struct SimulatedAddress {
  SimulatedSkinOptions options;
  double speed = 1;
};

SimulatedAddress parseAddress(const std::string& address) {
  constexpr std::string_view kPrefix = "sim:";
  const std::string what = "source \"" + address + "\": ";
  const std::size_t query = address.find('?');
  SimulatedAddress parsed;
  SimulatedSkinOptions& options = parsed.options;
  double& speed = parsed.speed;
  const std::string patch = address.substr(kPrefix.size(), query == std::string::npos ? query : query - kPrefix.size());
  std::vector<std::string> parts;
  if (query != std::string::npos) parts = split(address.substr(query + 1), '&');
  // Whoever moves the part comes first: it is a whole set of options.
  for (const std::string& part : parts) {
    if (part == "motion=robot") options = SimulatedSkinOptions::robot();
  }
  options.patch = patch;
  for (const std::string& part : parts) {
    const std::size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : part.substr(equals + 1);
    if (name == "surface") {
      options.surface = value;
    } else if (name == "seed") {
      options.seed = parseUnsigned(value, what + "seed");
    } else if (name == "speed") {
      speed = value == "max" ? std::numeric_limits<double>::infinity() : parseNumber(value, what + "speed");
    } else if (name != "motion" || (value != "hand" && value != "robot")) {
      throw InvalidArgument(
          message("source \"{}\": expected sim:PATCH[?surface=...&seed=N&speed=X|max&motion=hand|robot], found \"{}\"",
                  address, part));
    }
  }
  if (!(speed > 0)) throw InvalidArgument(message("source \"{}\": speed must be above 0", address));
  return parsed;
}

}  // namespace

std::unique_ptr<SkinSource> SimulatedSource::open(const std::string& address) {
  const SimulatedAddress parsed = parseAddress(address);
  return std::make_unique<SimulatedSource>(SimulatedSkin(builtInCellModel("hex-bma150"), parsed.options), parsed.speed,
                                           address);
}

void SimulatedSource::check(const std::string& address) {
  const SimulatedSkinOptions options = parseAddress(address).options;
  parsePatch(options.patch);
  if (!options.surface.empty()) makeSurface(options.surface);
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
