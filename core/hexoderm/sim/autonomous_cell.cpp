#include "hexoderm/sim/autonomous_cell.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

namespace hexoderm {
namespace {

using Kind = LocalMessage::Kind;

constexpr std::size_t kFrameBytes = 6;  // start, kind, length, checksum
constexpr std::size_t kIdBytes = 4;
constexpr std::size_t kPortBytes = 1;
constexpr std::size_t kHopBytes = 4;

/// Appends without copying where there is nothing to append to.
template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  if (to.empty()) {
    to = std::move(from);
  } else {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  }
}

}  // namespace

std::size_t LocalMessage::bytes() const {
  switch (kind) {
    case Kind::Offer:
      return kFrameBytes + kHopBytes;
    case Kind::Ask:
    case Kind::Tell:
      return kFrameBytes + kIdBytes + kPortBytes;
    case Kind::RollCall:
      return kFrameBytes + kIdBytes * remembered.size();
    case Kind::Numbers:
      return kFrameBytes + kIdBytes * number_count;
    case Kind::Report: {
      std::size_t size = kFrameBytes;
      for (const CellReport& cell : reports) size += kIdBytes + 1 + cell.neighbors.size() * (kIdBytes + 2 * kPortBytes);
      return size;
    }
    default:
      return kFrameBytes;
  }
}

AutonomousCell::AutonomousCell(std::vector<PortNumber> ports, CellId remembered, std::optional<CellId> interface_id,
                               const ExplorationOptions& options)
    : options_(options),
      remembered_(remembered),
      is_interface_(interface_id.has_value()),
      id_(interface_id.value_or(CellId())) {
  for (const PortNumber number : ports) ports_.push_back({number, false, {}, false, {}, false, false, {}});
}

void AutonomousCell::powerUp(Outlet& out) {
  awake_ = true;
  sayHello(out);
  if (is_interface_) out.wakeAfter(options_.discovery_wait_s, Alarm::Discovered, 0);
}

void AutonomousCell::sayHello(Outlet& out) {
  bool is_missed = false;
  for (std::size_t port = 0; port < ports_.size(); ++port) {
    if (ports_[port].works) continue;
    out.send(port, {Kind::Hello});
    is_missed = true;
  }
  if (is_missed && ++hellos_said_ < options_.hellos) out.wakeAfter(options_.hello_every_s, Alarm::Hello, 0);
}

void AutonomousCell::wake(Alarm alarm, std::size_t tag, Outlet& out) {
  switch (alarm) {
    case Alarm::Hello:
      return sayHello(out);
    case Alarm::Discovered:
      hops_ = 0;
      for (std::size_t port = 0; port < ports_.size(); ++port) offer(port, out);
      return settleAfterWait(out);
    case Alarm::Settled:
      if (tag != route_version_) return;
      settled_ = true;
      return tryRollCall(out);
    case Alarm::Listened:
      listened_ = true;
      return tryReport(out);
  }
}

void AutonomousCell::receive(std::size_t port, LocalMessage message, Outlet& out) {
  if (!awake_) return;
  PortState& from = ports_[port];
  switch (message.kind) {
    case Kind::Hello:
      return out.send(port, {Kind::HelloAnswer});
    case Kind::HelloAnswer:
      if (from.works) return;
      from.works = true;
      offer(port, out);
      return consider(port, out);
    case Kind::Offer:
      from.offer = message.hops;
      return consider(port, out);
    case Kind::Join:
      // A cell that answers too late stays without an ID until the next exploration.
      if (!called_) from.is_branch = true;
      return;
    case Kind::Leave:
      // A branch that has called the roll does not leave any more.
      from.is_branch = false;
      return tryRollCall(out);
    case Kind::RollCall:
      if (!from.is_branch || called_ || from.called) return;
      call_order_.push_back(port);
      from.called = message.remembered.size();
      append(roll_, std::move(message.remembered));
      return tryRollCall(out);
    case Kind::Numbers:
      return dealNumbers(message, out);
    case Kind::Numbered:
      from.numbered = true;
      return tryNumbered(out);
    case Kind::Explore:
      return explore(out);
    case Kind::Ask:
      from.neighbor = LinkEnd{message.id, message.port};
      if (hasId()) out.send(port, {Kind::Tell, 0, id_, from.number});
      return;
    case Kind::Tell:
      from.neighbor = LinkEnd{message.id, message.port};
      return;
    case Kind::Report:
      from.reported = true;
      append(reports_, std::move(message.reports));
      return tryReport(out);
  }
}

// ---- routes

void AutonomousCell::offer(std::size_t port, Outlet& out) {
  if (hops_ == kNone || port == parent_ || !ports_[port].works) return;
  out.send(port, {Kind::Offer, hops_});
}

void AutonomousCell::consider(std::size_t port, Outlet& out) {
  const PortState& from = ports_[port];
  if (is_interface_ || called_ || !from.works || !from.offer) return;
  if (hops_ != kNone && *from.offer + 1 >= hops_) return;
  if (parent_ != kNone) out.send(parent_, {Kind::Leave});
  parent_ = port;
  hops_ = *from.offer + 1;
  out.send(parent_, {Kind::Join});
  for (std::size_t other = 0; other < ports_.size(); ++other) offer(other, out);
  settleAfterWait(out);
}

void AutonomousCell::settleAfterWait(Outlet& out) {
  settled_ = false;
  out.wakeAfter(options_.settle_s, Alarm::Settled, ++route_version_);
}

template <class Done>
bool AutonomousCell::allBranches(Done done) const {
  return std::ranges::all_of(ports_, [&](const PortState& port) { return !port.is_branch || done(port); });
}

// ---- IDs

void AutonomousCell::tryRollCall(Outlet& out) {
  if (!settled_ || called_) return;
  if (!allBranches([](const PortState& port) { return port.called.has_value(); })) return;
  called_ = true;
  if (!is_interface_) {
    LocalMessage roll{Kind::RollCall};
    roll.remembered = std::move(roll_);
    roll.remembered.push_back(remembered_);
    return out.send(parent_, std::move(roll));
  }
  LocalMessage all{Kind::Numbers};
  all.numbers = assigned();
  all.number_count = all.numbers->size();
  dealNumbers(all, out);
}

/// The interface's work: an ID for everybody who called.
std::shared_ptr<const std::vector<CellId>> AutonomousCell::assigned() const {
  std::vector<CellId> numbers(roll_.size());
  std::unordered_set<CellId> taken;
  for (std::size_t k = 0; k < roll_.size(); ++k) {
    const bool can_keep = roll_[k].value() != 0 && roll_[k] < id_;
    if (can_keep && taken.insert(roll_[k]).second) numbers[k] = roll_[k];
  }
  std::uint32_t next = 1;
  for (CellId& number : numbers) {
    if (number.value() != 0) continue;
    while (taken.contains(CellId(next))) ++next;
    number = CellId(next++);
  }
  return std::make_shared<const std::vector<CellId>>(std::move(numbers));
}

void AutonomousCell::dealNumbers(const LocalMessage& message, Outlet& out) {
  if (!is_interface_) id_ = message.numbers->at(message.first_number + message.number_count - 1);
  // The roll was called in the order in which the branches' calls came, so it is dealt in this order.
  std::size_t first = message.first_number;
  for (const std::size_t port : call_order_) {
    LocalMessage part{Kind::Numbers};
    part.numbers = message.numbers;
    part.first_number = first;
    part.number_count = *ports_[port].called;
    first += part.number_count;
    out.send(port, std::move(part));
  }
  tryNumbered(out);
}

void AutonomousCell::tryNumbered(Outlet& out) {
  if (numbered_ || !allBranches([](const PortState& port) { return port.numbered; })) return;
  numbered_ = true;
  if (is_interface_) return explore(out);
  out.send(parent_, {Kind::Numbered});
}

// ---- neighbours

void AutonomousCell::explore(Outlet& out) {
  for (std::size_t port = 0; port < ports_.size(); ++port) {
    if (ports_[port].is_branch) out.send(port, {Kind::Explore});
  }
  for (std::size_t port = 0; port < ports_.size(); ++port) out.send(port, {Kind::Ask, 0, id_, ports_[port].number});
  out.wakeAfter(options_.neighbor_wait_s, Alarm::Listened, 0);
}

void AutonomousCell::tryReport(Outlet& out) {
  if (!listened_ || finished_ || !allBranches([](const PortState& port) { return port.reported; })) return;
  finished_ = true;
  if (is_interface_) return;
  CellReport own{id_, "", {}};
  for (const PortState& port : ports_) {
    if (port.neighbor) own.neighbors.push_back({port.number, port.neighbor->cell, port.neighbor->port});
  }
  LocalMessage message{Kind::Report};
  message.reports = std::move(reports_);
  message.reports.push_back(std::move(own));
  out.send(parent_, std::move(message));
}

}  // namespace hexoderm
