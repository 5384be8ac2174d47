#include "hexoderm/sim/exploration.h"

#include "hexoderm/base/error.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace hexoderm {
namespace {

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
};

using Kind = LocalMessage::Kind;

/// A cell that explores its neighbourhood by messages, and the interface, which does the same.
class AutonomousCell {
 public:
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

// ---- routes

// ---- IDs

// ---- neighbours

constexpr double kBitsPerByte = 10;  // start and stop bit
// Long lists go in packets, which a cell passes on as they come.
constexpr std::size_t kPacketBytes = 64;

/// A port of a node, both by index.
struct Socket {
  std::size_t node = 0;
  std::size_t port = 0;
  friend bool operator==(const Socket&, const Socket&) = default;
};

/// The world outside the cells: who is joined to whom, how long everything takes, and what is broken.
class Network {
 public:
  Network(const NeighborList& wiring, const CellModel& model, const std::vector<LinkEnd>& interface_at,
          const ExplorationOptions& options)
      : options_(options), ports_(sortedPorts(model)) {
    index_.reserve(wiring.size());
    cells_.reserve(wiring.size() + 1);
    for (std::size_t k = 0; k < wiring.size(); ++k) {
      const CellId id = wiring[k].id;
      if (id.value() == 0 || id >= model.interface_id || !index_.emplace(id, k).second) {
        throw InvalidArgument(
            message("exploration: cell {} of the wiring is there twice, or its ID is not one of a cell", id));
      }
      cells_.emplace_back(ports_, options.ids_remembered ? id : CellId(), std::nullopt, options_);
      plugs_.emplace_back(ports_.size());
    }
    std::vector<PortNumber> interface_ports;
    while (interface_ports.size() < interface_at.size()) {
      interface_ports.emplace_back(static_cast<std::uint32_t>(interface_ports.size()) + 1);
    }
    cells_.emplace_back(interface_ports, CellId(), model.interface_id, options_);
    plugs_.emplace_back(interface_ports.size());
    dead_.resize(cells_.size(), false);
    for (std::size_t k = 0; k < wiring.size(); ++k) {
      for (const NeighborReport& link : wiring[k].neighbors) {
        if (link.cell.value() == 0 || link.cell >= model.interface_id) continue;
        if (!link.cell_port) throw InvalidArgument(message("exploration: a link of the wiring has an unknown port"));
        join({k, portIndex({wiring[k].id, link.port})}, socketAt({link.cell, *link.cell_port}));
      }
    }
    for (std::size_t k = 0; k < interface_at.size(); ++k) join({cells_.size() - 1, k}, socketAt(interface_at[k]));
    for (const CellId dead : options.dead_cells) dead_[nodeOf(dead)] = true;
    for (const PortFault& fault : options.port_faults) {
      const Socket at = socketAt(fault.at);
      Plug& plug = plugs_[at.node][at.port];
      plug.is_deaf = plug.is_deaf || fault.kind != PortFaultKind::Mute;
      plug.is_mute = plug.is_mute || fault.kind != PortFaultKind::Deaf;
    }
  }

  Exploration run() {
    // Not the library's distribution: the same everywhere.
    std::mt19937_64 random(options_.seed);
    for (std::size_t node = 0; node < cells_.size(); ++node) {
      const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
      if (dead_[node]) continue;
      at(options_.power_up_s + options_.power_up_spread_s * share, node,
         [](AutonomousCell& cell, NodeOutlet& out) { cell.powerUp(out); });
    }
    AutonomousCell& interface = cells_.back();
    while (!events_.empty() && !interface.isFinished()) {
      std::ranges::pop_heap(events_, isLater);
      const Event event = std::move(events_.back());
      events_.pop_back();
      now_s_ = event.time_s;
      NodeOutlet out(*this, event.node);
      event.happen(cells_[event.node], out);
    }
    Exploration result;
    result.cells = interface.takeReports();
    std::ranges::sort(result.cells, {}, &CellReport::id);
    result.duration_s = now_s_;
    result.waiting_s = options_.power_up_s + options_.discovery_wait_s + options_.settle_s + options_.neighbor_wait_s;
    result.messages = messages_;
    for (std::size_t k = 0; k + 1 < cells_.size(); ++k) {
      if (cells_[k].hasId()) result.longest_route = std::max(result.longest_route, cells_[k].hops());
    }
    return result;
  }

 private:
  struct Plug {
    std::optional<Socket> other;
    bool is_deaf = false, is_mute = false;
    double free_at_s = 0;  ///< earlier messages have been sent by then
  };
  class NodeOutlet final : public AutonomousCell::Outlet {
   public:
    NodeOutlet(Network& network, std::size_t node) : network_(network), node_(node) {}
    void send(std::size_t port, LocalMessage message) override { network_.send({node_, port}, std::move(message)); }
    void wakeAfter(double seconds, AutonomousCell::Alarm alarm, std::size_t tag) override {
      network_.at(network_.now_s_ + seconds, node_,
                  [alarm, tag](AutonomousCell& cell, NodeOutlet& out) { cell.wake(alarm, tag, out); });
    }

   private:
    Network& network_;
    std::size_t node_;
  };

  using Happening = std::function<void(AutonomousCell&, NodeOutlet&)>;
  struct Event {
    double time_s = 0;
    std::size_t number = 0;
    std::size_t node = 0;
    Happening happen;
  };

  static bool isLater(const Event& a, const Event& b) {
    return std::tie(a.time_s, a.number) > std::tie(b.time_s, b.number);
  }

  static std::vector<PortNumber> sortedPorts(const CellModel& model) {
    std::vector<PortNumber> ports;
    for (const Port& port : model.ports) ports.push_back(port.number);
    std::ranges::sort(ports);
    return ports;
  }

  std::size_t nodeOf(CellId cell) const {
    const auto found = index_.find(cell);
    if (found == index_.end()) throw InvalidArgument(message("exploration: there is no cell {}", cell));
    return found->second;
  }
  std::size_t portIndex(const LinkEnd& end) const {
    const auto found = std::ranges::find(ports_, end.port);
    if (found == ports_.end())
      throw InvalidArgument(message("exploration: {}: the model has no such port", inWords(end)));
    return static_cast<std::size_t>(found - ports_.begin());
  }
  Socket socketAt(const LinkEnd& end) const { return {nodeOf(end.cell), portIndex(end)}; }

  void join(const Socket& a, const Socket& b) {
    for (const auto& [here, there] : {std::pair(a, b), std::pair(b, a)}) {
      std::optional<Socket>& other = plugs_[here.node][here.port].other;
      if (other && *other != there) {
        throw InvalidArgument(
            message("exploration: port {} of the wiring's cell {} is joined twice", ports_[here.port], here.node + 1));
      }
      other = there;
    }
  }

  void at(double time_s, std::size_t node, Happening happen) {
    events_.push_back({time_s, pushed_++, node, std::move(happen)});
    std::ranges::push_heap(events_, isLater);
  }

  [[nodiscard]] double duration_s(std::size_t bytes) const {
    return kBitsPerByte * static_cast<double>(bytes) / options_.bits_per_s;
  }

  void send(const Socket& from, LocalMessage message) {
    Plug& plug = plugs_[from.node][from.port];
    const std::size_t bytes = message.bytes();
    messages_ += (bytes + kPacketBytes - 1) / kPacketBytes;
    const double begin_s = std::max(now_s_, plug.free_at_s);
    plug.free_at_s = begin_s + duration_s(bytes);
    if (plug.is_mute || !plug.other || dead_[plug.other->node]) return;
    if (plugs_[plug.other->node][plug.other->port].is_deaf) return;
    // A cell passes it on from the first packet; the interface needs all of it.
    const bool is_last = plug.other->node + 1 == cells_.size();
    const double heard_s =
        begin_s + duration_s(is_last ? bytes : std::min(bytes, kPacketBytes)) + options_.processing_s;
    at(heard_s, plug.other->node,
       [port = plug.other->port, message = std::move(message)](AutonomousCell& cell, NodeOutlet& out) mutable {
         cell.receive(port, std::move(message), out);
       });
  }

  const ExplorationOptions& options_;
  std::vector<PortNumber> ports_;
  std::unordered_map<CellId, std::size_t> index_;
  std::vector<AutonomousCell> cells_;  ///< the interface last
  std::vector<std::vector<Plug>> plugs_;
  std::vector<bool> dead_;
  std::vector<Event> events_;  ///< a heap, the next in front
  std::size_t pushed_ = 0;
  std::size_t messages_ = 0;
  double now_s_ = 0;
};

/// A number for the patch of each cell: cells that are joined, whichever end says so, have the same.
std::vector<std::size_t> patchesOf(const NeighborList& wiring) {
  std::unordered_map<CellId, std::size_t> index;
  for (std::size_t k = 0; k < wiring.size(); ++k) index.emplace(wiring[k].id, k);
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> joined(wiring.size());
  for (std::size_t k = 0; k < wiring.size(); ++k) {
    for (const NeighborReport& link : wiring[k].neighbors) {
      const auto other = index.find(link.cell);
      if (other != index.end()) add_edge(k, other->second, joined);
    }
  }
  std::vector<std::size_t> patch_of(wiring.size());
  boost::connected_components(joined, patch_of.data());
  return patch_of;
}

}  // namespace

void ExplorationOptions::validate() const {
  const auto check = [](double value, const char* name, bool may_be_zero) {
    if (std::isfinite(value) && (value > 0 || (may_be_zero && value == 0))) return;
    throw InvalidArgument(may_be_zero ? message("exploration: {} must not be negative", name)
                                      : message("exploration: {} must be above 0, not less", name));
  };
  check(power_up_s, "power_up_s", true);
  check(power_up_spread_s, "power_up_spread_s", true);
  check(hello_every_s, "hello_every_s", false);
  check(discovery_wait_s, "discovery_wait_s", true);
  check(settle_s, "settle_s", false);
  check(neighbor_wait_s, "neighbor_wait_s", false);
  check(bits_per_s, "bits_per_s", false);
  check(processing_s, "processing_s", true);
  if (hellos == 0) throw InvalidArgument(message("exploration: hellos must be at least 1"));
}

Exploration exploreNetwork(const NeighborList& wiring, const CellModel& model, const std::vector<LinkEnd>& interface_at,
                           const ExplorationOptions& options) {
  options.validate();
  return Network(wiring, model, interface_at, options).run();
}

std::vector<LinkEnd> firstFreePorts(const NeighborList& wiring, const CellModel& model) {
  const std::vector<std::size_t> patch_of = patchesOf(wiring);
  std::map<std::size_t, std::optional<LinkEnd>> first_of;
  for (std::size_t k = 0; k < wiring.size(); ++k) {
    std::optional<LinkEnd>& first = first_of[patch_of[k]];
    for (const Port& port : model.ports) {
      const bool is_free = std::ranges::none_of(wiring[k].neighbors, [&](const NeighborReport& link) {
        return link.port == port.number && link.cell.value() != 0;
      });
      const LinkEnd end{wiring[k].id, port.number};
      if (is_free && (!first || end < *first)) first = end;
    }
  }
  std::vector<LinkEnd> ends;
  for (const auto& [patch, end] : first_of) {
    if (end) ends.push_back(*end);
  }
  if (ends.empty() || ends.size() < first_of.size()) {
    throw InvalidArgument(message("no port of the skin is free for a computer interface"));
  }
  return ends;
}

}  // namespace hexoderm
