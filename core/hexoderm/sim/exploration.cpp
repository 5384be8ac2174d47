#include "hexoderm/sim/exploration.h"

#include "hexoderm/base/error.h"
#include "hexoderm/sim/autonomous_cell.h"

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
