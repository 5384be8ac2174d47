#pragma once

#include "hexoderm/sim/exploration.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace hexoderm {

/// A message from port to port. Each kind uses some of the fields.
struct LocalMessage {
  enum class Kind {
    Hello,
    HelloAnswer,
    Offer,     ///< hops: a route to the interface
    Join,      ///< I take your offer
    Leave,     ///< I took a better one
    RollCall,  ///< remembered: the IDs of the sender's branch as they were before, the sender's own last
    Numbers,   ///< numbers: the new ones, in the same order
    Numbered,  ///< the whole branch is
    Explore,   ///< now everybody has an ID
    Ask,       ///< id, port: mine. Yours?
    Tell,      ///< id, port
    Report,    ///< reports of the branch
  };
  Kind kind{};
  std::size_t hops = 0;
  CellId id{};
  PortNumber port{};
  std::vector<CellId> remembered{};
  /// Part of a list that all branches share here; a real cell would pass its part on.
  std::shared_ptr<const std::vector<CellId>> numbers{};
  std::size_t first_number = 0;
  std::size_t number_count = 0;
  NeighborList reports{};

  /// On the wire, with head and checksum.
  [[nodiscard]] std::size_t bytes() const {
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
        for (const CellReport& cell : reports)
          size += kIdBytes + 1 + cell.neighbors.size() * (kIdBytes + 2 * kPortBytes);
        return size;
      }
      default:
        return kFrameBytes;
    }
  }

 private:
  static constexpr std::size_t kFrameBytes = 6;  // start, kind, length, checksum
  static constexpr std::size_t kIdBytes = 4;
  static constexpr std::size_t kPortBytes = 1;
  static constexpr std::size_t kHopBytes = 4;
};

/// A cell that explores its neighbourhood by messages, and the interface, which does the same.
class AutonomousCell {
 public:
  using Kind = LocalMessage::Kind;
  enum class Alarm { Hello, Discovered, Settled, Listened };

  /// All that a cell can do to the world.
  class Outlet {
   public:
    virtual ~Outlet() = default;
    /// `port` is the index of one of the cell's own ports.
    virtual void send(std::size_t port, LocalMessage message) = 0;
    virtual void wakeAfter(double seconds, Alarm alarm, std::size_t tag) = 0;
  };

  /// `interface_id`: this is the interface, and begins the routes.
  AutonomousCell(std::vector<PortNumber> ports, CellId remembered, std::optional<CellId> interface_id,
                 const ExplorationOptions& options)
      : options_(options),
        remembered_(remembered),
        is_interface_(interface_id.has_value()),
        id_(interface_id.value_or(CellId())) {
    for (const PortNumber number : ports) ports_.push_back({number, false, {}, false, {}, false, false, {}});
  }

  void powerUp(Outlet& out) {
    awake_ = true;
    sayHello(out);
    if (is_interface_) out.wakeAfter(options_.discovery_wait_s, Alarm::Discovered, 0);
  }
  void receive(std::size_t port, LocalMessage message, Outlet& out) {
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
  void wake(Alarm alarm, std::size_t tag, Outlet& out) {
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

  /// Whether every branch has reported; only the interface knows.
  [[nodiscard]] bool isFinished() const { return finished_; }
  [[nodiscard]] NeighborList takeReports() { return std::move(reports_); }
  [[nodiscard]] std::size_t hops() const { return hops_; }
  [[nodiscard]] bool hasId() const { return id_.value() != 0; }

 private:
  /// Appends without copying where there is nothing to append to.
  template <class T>
  static void append(std::vector<T>& to, std::vector<T>&& from) {
    if (to.empty()) {
      to = std::move(from);
    } else {
      to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    }
  }

  struct PortState {
    PortNumber number;
    bool works = false;  ///< hello was answered
    std::optional<std::size_t> offer;
    bool is_branch = false;
    std::optional<std::size_t> called;  ///< cells of the branch, once it called
    bool numbered = false, reported = false;
    std::optional<LinkEnd> neighbor;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void sayHello(Outlet& out) {
    bool is_missed = false;
    for (std::size_t port = 0; port < ports_.size(); ++port) {
      if (ports_[port].works) continue;
      out.send(port, {Kind::Hello});
      is_missed = true;
    }
    if (is_missed && ++hellos_said_ < options_.hellos) out.wakeAfter(options_.hello_every_s, Alarm::Hello, 0);
  }
  void offer(std::size_t port, Outlet& out) {
    if (hops_ == kNone || port == parent_ || !ports_[port].works) return;
    out.send(port, {Kind::Offer, hops_});
  }
  void consider(std::size_t port, Outlet& out) {
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
  void settleAfterWait(Outlet& out) {
    settled_ = false;
    out.wakeAfter(options_.settle_s, Alarm::Settled, ++route_version_);
  }
  void tryRollCall(Outlet& out) {
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
  void dealNumbers(const LocalMessage& message, Outlet& out) {
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
  void tryNumbered(Outlet& out) {
    if (numbered_ || !allBranches([](const PortState& port) { return port.numbered; })) return;
    numbered_ = true;
    if (is_interface_) return explore(out);
    out.send(parent_, {Kind::Numbered});
  }
  void explore(Outlet& out) {
    for (std::size_t port = 0; port < ports_.size(); ++port) {
      if (ports_[port].is_branch) out.send(port, {Kind::Explore});
    }
    for (std::size_t port = 0; port < ports_.size(); ++port) out.send(port, {Kind::Ask, 0, id_, ports_[port].number});
    out.wakeAfter(options_.neighbor_wait_s, Alarm::Listened, 0);
  }
  void tryReport(Outlet& out) {
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
  template <class Done>
  [[nodiscard]] bool allBranches(Done done) const {
    return std::ranges::all_of(ports_, [&](const PortState& port) { return !port.is_branch || done(port); });
  }
  /// The interface's work: an ID for everybody who called.
  [[nodiscard]] std::shared_ptr<const std::vector<CellId>> assigned() const {
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

  const ExplorationOptions& options_;
  std::vector<PortState> ports_;
  CellId remembered_;
  bool is_interface_;
  CellId id_;
  bool awake_ = false;
  unsigned hellos_said_ = 0;
  std::size_t hops_ = kNone;
  std::size_t parent_ = kNone;
  std::size_t route_version_ = 0;
  bool settled_ = false, called_ = false, numbered_ = false, listened_ = false, finished_ = false;
  std::vector<CellId> roll_;
  std::vector<std::size_t> call_order_;  ///< ports, as their branches called
  NeighborList reports_;
};

}  // namespace hexoderm
