#include "hexoderm/sim/emulated_device.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/text.h"
#include "hexoderm/device/skinwire/codec.h"
#include "hexoderm/device/skinwire/description.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hexoderm {
namespace {

constexpr std::size_t kMaxAnswered = 1000;
// Largest size of a message of samples in LSB: its head, an ID, and three values of two bytes.
constexpr std::size_t kHeadBytes = 80;
constexpr std::size_t kCellIdBytes = 3;
constexpr std::size_t kSampleBytes = 6;
constexpr const char* kSentElsewhere = "the part was sent elsewhere";

std::string noSuchCell(std::uint32_t cell) { return "there is no cell " + std::to_string(cell); }

/// Word of a command that takes its time.
skinwire::Ack working(std::uint32_t command) { return {command, false, "", true}; }

}  // namespace

void EmulatedDeviceOptions::validate() const {
  const auto check = [](bool is_good, const std::string& what) {
    if (!is_good) throw InvalidArgument("emulated device: expected " + what);
  };
  check(std::isfinite(rate_hz) && rate_hz >= 0, "a rate above 0, or 0 for the cell model's");
  check(max_body >= 200, "max_body of at least 200 bytes");
  check(message_every_s > 0 && status_every_s > 0 && working_every_s > 0, "times above 0");
  exploration.validate();
}

EmulatedDevice::EmulatedDevice(std::unique_ptr<SimulatedBody> body, EmulatedDeviceOptions options)
    : body_(std::move(body)),
      options_(std::move(options)),
      leds_(body_->neighbors().size()),
      encoder_(body_->model().accelerometer.lsb_g, options_.max_body),
      sums_(body_->neighbors().size()) {
  options_.validate();
  requireRoomForJoints();
  for (const CellFault& fault : body_->cellFaults()) cell_faults_[fault.cell].push_back(fault.kind);
  if (options_.rate_hz > 0) {
    if (const std::string why = setRate(options_.rate_hz); !why.empty()) throw InvalidArgument(why);
  }
  Messages nobody;
  startExploring(nobody);
}

std::uint64_t EmulatedDevice::ticksIn(double seconds) const {
  return static_cast<std::uint64_t>(std::max(1.0, std::ceil(seconds / tick_s())));
}

// ---- exploring

void EmulatedDevice::startExploring(Messages& out) {
  flush(out);
  const NeighborList& wiring = body_->neighbors();
  exploration_ = exploreNetwork(wiring, body_->model(), firstFreePorts(wiring, body_->model()), options_.exploration);
  explored_at_ = ticks_ + ticksIn(exploration_.duration_s);
  status_at_ = ticks_ + ticksIn(options_.status_every_s);
  if (has_host_) out.emplace_back(status());
}

void EmulatedDevice::finishExploring(Messages& out) {
  if (topology_id_ == 0 || topology_ != exploration_.cells) {
    topology_ = exploration_.cells;
    ++topology_id_;
  }
  found_.clear();
  if (topology_.size() != body_->neighbors().size()) {
    found_.resize(body_->neighbors().size(), false);
    for (const CellReport& cell : topology_) found_.at(cell.id.value() - 1) = true;
  }
  std::ranges::fill(sums_, Sums{});
  summed_ticks_ = 0;
  if (has_host_) describe(std::nullopt, out);
  for (const Turn& asked : std::exchange(exploring_, {})) answer({asked.command, true}, out);
}

void EmulatedDevice::exploreAgain(Messages& out) {
  if (!isExploring()) startExploring(out);
}

void EmulatedDevice::restart(std::vector<LinkFault> link_faults, Messages& out) {
  // The new body is made first, because that may throw. Faults of cells are carried over.
  std::unique_ptr<SimulatedBody> body = body_->withLinkFaults(std::move(link_faults));
  firstFreePorts(body->neighbors(), body->model());
  for (const auto& [cell, kinds] : cell_faults_) {
    for (const SkinFault kind : kinds) body->breakCell({kind, cell});
  }
  body_ = std::move(body);
  ++stream_;
  ticks_ = 0;
  batch_.clear();
  joint_reporting_ = {};
  encoder_ = skinwire::SampleEncoder(body_->model().accelerometer.lsb_g, options_.max_body);
  skipped_ = dropped_ = 0;
  dropTurn("the device was restarted", out);
  for (const Turn& asked : std::exchange(exploring_, {}))
    answer({asked.command, false, "the device was restarted"}, out);
  if (has_host_) out.emplace_back(hello());
  startExploring(out);
}

bool EmulatedDevice::isFound(CellId cell) const {
  if (cell.value() == 0 || cell.value() > body_->neighbors().size()) return false;
  return found_.empty() || found_[cell.value() - 1];
}

// ---- the host

skinwire::Hello EmulatedDevice::hello() const {
  const SkinDescription description{located("emulated skin", body_->description()),
                                    std::make_shared<const CellModel>(body_->model()),
                                    {},
                                    true,
                                    body_->turnsOnRequest()};
  return skinwire::helloOf(description, rate_hz(), stream_);
}

skinwire::Status EmulatedDevice::status() const {
  const std::uint64_t encoded = encoder_.sequence();
  const std::uint64_t unsent = dropped_ - skipped_;
  return {isExploring() ? "exploring the network of cells" : "", isExploring(), encoded - std::min(encoded, unsent),
          dropped_};
}

void EmulatedDevice::describe(const std::optional<std::uint32_t>& known_topology, Messages& out) {
  out.emplace_back(hello());
  joints_.nameAgain();
  if (topology_id_ == 0) {
    out.emplace_back(status());
  } else if (known_topology != topology_id_) {
    for (skinwire::Topology& part : skinwire::topologyParts(topology_, topology_id_, options_.max_body)) {
      out.emplace_back(std::move(part));
    }
  }
}

void EmulatedDevice::greet(Messages& out) {
  forgetHost();
  has_host_ = true;
  status_at_ = ticks_ + ticksIn(options_.status_every_s);
  describe(std::nullopt, out);
}

void EmulatedDevice::forgetHost() {
  has_host_ = false;
  answered_.clear();
  turning_.reset();
  exploring_.clear();
  batch_.clear();
}

void EmulatedDevice::take(const skinwire::Command& command, Messages& out) {
  if (const auto* describe_request = std::get_if<skinwire::Describe>(&command.request)) {
    return describe(describe_request->known_topology, out);
  }
  if (const auto answered = answered_.find(command.number); answered != answered_.end()) {
    out.emplace_back(answered->second);
    return;
  }
  if (const auto* rate = std::get_if<skinwire::SetRate>(&command.request)) {
    const double before_hz = rate_hz();
    flush(out);
    const std::string why = setRate(rate->rate_hz);
    answer({command.number, why.empty(), why}, out);
    if (rate_hz() != before_hz && has_host_) out.emplace_back(hello());
  } else if (const auto* led = std::get_if<skinwire::SetLed>(&command.request)) {
    const bool is_there = isFound(CellId(led->cell));
    if (is_there) leds_.at(led->cell - 1) = {led->red, led->green, led->blue};
    answer({command.number, is_there, is_there ? "" : noSuchCell(led->cell)}, out);
  } else if (const auto* turn_to = std::get_if<skinwire::TurnTo>(&command.request)) {
    turn(command.number, *turn_to, out);
  } else if (std::holds_alternative<skinwire::ExploreAgain>(command.request)) {
    exploreAgain(out);
    exploring_.push_back({command.number, ticks_ + ticksIn(options_.working_every_s)});
    answer(working(command.number), out);
  } else {
    answer({command.number, false, "this device does not know that command"}, out);
  }
}

void EmulatedDevice::answer(const skinwire::Ack& ack, Messages& out) {
  if (ack.command == 0 || !has_host_) return;
  // Numbers grow: the oldest will not be asked again.
  if (answered_.size() >= kMaxAnswered) answered_.erase(answered_.begin());
  answered_[ack.command] = ack;
  out.emplace_back(ack);
}

std::string EmulatedDevice::setRate(double rate_hz) {
  const double most_hz = body_->rate_hz();
  if (!(rate_hz > 0) || rate_hz > most_hz * 1.0001 || rate_hz < most_hz / 1e6) {
    return "expected a rate above 0 and at most " + formatFixed(most_hz, 0) + " Hz";
  }
  divider_ = static_cast<std::size_t>(std::max(1.0, std::round(most_hz / rate_hz)));
  return "";
}

std::array<std::uint8_t, 3> EmulatedDevice::led(CellId cell) const {
  body_->requireCell(cell);
  return leds_.at(cell.value() - 1);
}

void EmulatedDevice::turn(std::uint32_t command, const skinwire::TurnTo& request, Messages& out) {
  if (!isFound(CellId(request.cell))) {
    return answer({command, false, noSuchCell(request.cell)}, out);
  }
  if (!body_->turnsOnRequest()) return answer({command, false, "the part is turned by itself"}, out);
  try {
    body_->turnTo(CellId(request.cell), request.up_u);
  } catch (const InvalidArgument& error) {
    return answer({command, false, error.what()}, out);
  }
  dropTurn(kSentElsewhere, out);
  if (!body_->turning()) return answer({command, true}, out);
  turning_ = {command, ticks_ + ticksIn(options_.working_every_s)};
  answer(working(command), out);
}

void EmulatedDevice::dropTurn(std::string why, Messages& out) {
  if (turning_) answer({std::exchange(turning_, std::nullopt)->command, false, std::move(why)}, out);
}

void EmulatedDevice::turnTo(const Eigen::Vector3d& up_b, Messages& out) {
  body_->turnTo(up_b);
  dropTurn(kSentElsewhere, out);
}

void EmulatedDevice::turnToNextPose(Messages& out) {
  body_->turnToNextPose();
  dropTurn(kSentElsewhere, out);
}

void EmulatedDevice::tendCommands(Messages& out) {
  if (turning_ && !body_->turning()) answer({std::exchange(turning_, std::nullopt)->command, true}, out);
  const auto keepWaiting = [&](Turn& asked) {
    if (ticks_ < asked.say_at) return;
    asked.say_at = ticks_ + ticksIn(options_.working_every_s);
    answer(working(asked.command), out);
  };
  if (turning_) keepWaiting(*turning_);
  for (Turn& asked : exploring_) keepWaiting(asked);
}

// ---- time

void EmulatedDevice::tick(Messages& out) {
  const bool was_exploring = isExploring();
  if (!was_exploring && has_host_) tellJoints(out);
  if (!was_exploring && has_host_ && ticks_ % divider_ == 0) {
    SampleFrame frame = body_->next();
    frame.time_s = time_s();
    takeSamples(std::move(frame), out);
  } else {
    body_->skip(1);
  }
  ++ticks_;
  if (was_exploring && !isExploring()) finishExploring(out);
  if (!has_host_) return;
  tendCommands(out);
  if (ticks_ < status_at_) return;
  status_at_ = ticks_ + ticksIn(options_.status_every_s);
  out.emplace_back(status());
}

void EmulatedDevice::skip(std::size_t ticks, Messages& out) {
  flush(out);
  // The network is explored in real time.
  while (ticks > 0 && isExploring()) {
    tick(out);
    --ticks;
  }
  if (has_host_) {
    const std::size_t taken = (ticks_ + ticks + divider_ - 1) / divider_ - (ticks_ + divider_ - 1) / divider_;
    std::size_t lost = taken * topology_.size();
    if (options_.means_of > 0) {
      // A mean of fewer samples is still one, and says of how many.
      const std::size_t due = (summed_ticks_ + taken) / options_.means_of;
      lost = due * topology_.size();
      if (due > 0) lost -= std::min(lost, sendMeans(out));
      summed_ticks_ = static_cast<std::uint32_t>((summed_ticks_ + taken) % options_.means_of);
    }
    skipped_ += lost;
    dropped_ += lost;
  }
  body_->skip(ticks);
  ticks_ += ticks;
  if (has_host_) tendCommands(out);
}

void EmulatedDevice::countDropped(const skinwire::Samples& samples) {
  dropped_ += samples.ticks() * samples.cells.size();
}

std::size_t EmulatedDevice::ticksPerMessage() const {
  if (options_.means_of > 0) return 1;
  const std::size_t cells = std::max<std::size_t>(1, topology_.size());
  const std::size_t room = options_.max_body - std::min(options_.max_body, kHeadBytes + kCellIdBytes * cells);
  const double wanted = std::floor(options_.message_every_s * rate_hz() + 0.5);
  return std::max<std::size_t>(1, std::min(static_cast<std::size_t>(wanted), room / (kSampleBytes * cells)));
}

/// A message with the names can't be parted, and without the names the others are of no use.
void EmulatedDevice::requireRoomForJoints() const {
  const JointReport report{time_s(), body_->jointAngles()};
  if (report.angles.positions.empty()) return;
  const std::size_t bytes = skinwire::encodeBody(skinwire::JointsEncoder().encode(report)).size();
  if (bytes <= options_.max_body) return;
  throw InvalidArgument(message("the names and angles of {} joints take {} bytes, and a message on this wire has {}",
                                report.angles.positions.size(), bytes, options_.max_body));
}

void EmulatedDevice::tellJoints(Messages& out) {
  const std::optional<JointReport> report = joint_reporting_.before(*body_, time_s());
  if (!report) return;
  flush(out);
  out.emplace_back(joints_.encode(*report));
}

void EmulatedDevice::takeSamples(SampleFrame frame, Messages& out) {
  if (!found_.empty()) std::erase_if(frame.samples, [&](const CellSample& sample) { return !isFound(sample.cell); });
  if (options_.means_of > 0) return average(frame, out);
  batch_.push_back(std::move(frame));
  if (batch_.size() >= ticksPerMessage()) flush(out);
}

void EmulatedDevice::average(const SampleFrame& frame, Messages& out) {
  for (const CellSample& sample : frame.samples) {
    Sums& sums = sums_[sample.cell.value() - 1];
    sums.sum_g += sample.acceleration_g;
    sums.squares_g2 += sample.acceleration_g.cwiseAbs2();
    ++sums.count;
  }
  summed_until_s_ = frame.time_s;
  if (++summed_ticks_ < options_.means_of) return;
  summed_ticks_ = 0;
  sendMeans(out);
}

std::size_t EmulatedDevice::sendMeans(Messages& out) {
  SampleFrame means;
  means.time_s = summed_until_s_;
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    const Sums sums = std::exchange(sums_[k], Sums{});
    if (sums.count == 0) continue;
    const double n = sums.count;
    const Eigen::Vector3d mean_g = sums.sum_g / n;
    Eigen::Vector3d variance_g2 = Eigen::Vector3d::Zero();
    if (sums.count > 1) variance_g2 = ((sums.squares_g2 - n * mean_g.cwiseAbs2()) / (n - 1)).cwiseMax(0.0);
    means.means.push_back({CellId(static_cast<std::uint32_t>(k + 1)), mean_g, variance_g2, sums.count});
  }
  std::vector<skinwire::Samples> samples;
  encoder_.encode(means, samples);
  send(std::move(samples), out);
  return means.means.size();
}

void EmulatedDevice::flush(Messages& out) {
  if (batch_.empty()) return;
  std::vector<skinwire::Samples> samples;
  encoder_.encodeBatch(batch_, samples);
  batch_.clear();
  send(std::move(samples), out);
}

void EmulatedDevice::send(std::vector<skinwire::Samples> samples, Messages& out) {
  for (skinwire::Samples& message : samples) {
    // The encoder does not know of what was skipped, and the host is to know of every loss.
    if (message.sequence) *message.sequence += skipped_;
    out.emplace_back(std::move(message));
  }
}

// ---- faults

void EmulatedDevice::breakCell(const CellFault& fault) {
  body_->breakCell(fault);
  cell_faults_[fault.cell].push_back(fault.kind);
}

void EmulatedDevice::mendCell(CellId cell) {
  body_->mendCell(cell);
  cell_faults_.erase(cell);
  std::erase(options_.exploration.dead_cells, cell);
}

void EmulatedDevice::breakController(CellId cell) {
  body_->requireCell(cell);
  options_.exploration.dead_cells.push_back(cell);
}

void EmulatedDevice::breakPort(const PortFault& fault) {
  body_->requireCell(fault.at.cell);
  static_cast<void>(body_->model().port(fault.at.port));
  options_.exploration.port_faults.push_back(fault);
}

bool EmulatedDevice::mendPort(const LinkEnd& at) {
  return std::erase_if(options_.exploration.port_faults, [&](const PortFault& fault) { return fault.at == at; }) > 0;
}

void EmulatedDevice::breakLink(const LinkFault& fault, Messages& out) {
  std::vector<LinkFault> faults = body_->linkFaults();
  faults.push_back(fault);
  restart(std::move(faults), out);
}

bool EmulatedDevice::mendLink(const LinkEnd& at, Messages& out) {
  std::vector<LinkFault> faults = body_->linkFaults();
  if (std::erase_if(faults, [&](const LinkFault& fault) { return fault.at == at; }) == 0) return false;
  restart(std::move(faults), out);
  return true;
}

}  // namespace hexoderm
