#pragma once

// A cell that explores its neighbourhood by messages, and the interface, which does the same.

#include "hexoderm/sim/exploration.h"

#include <memory>
#include <optional>
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
  [[nodiscard]] std::size_t bytes() const;
};

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
                 const ExplorationOptions& options);

  void powerUp(Outlet& out);
  void receive(std::size_t port, LocalMessage message, Outlet& out);
  void wake(Alarm alarm, std::size_t tag, Outlet& out);

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

  void sayHello(Outlet& out);
  void offer(std::size_t port, Outlet& out);
  void consider(std::size_t port, Outlet& out);
  void settleAfterWait(Outlet& out);
  void tryRollCall(Outlet& out);
  void dealNumbers(const LocalMessage& message, Outlet& out);
  void tryNumbered(Outlet& out);
  void explore(Outlet& out);
  void tryReport(Outlet& out);
  template <class Done>
  [[nodiscard]] bool allBranches(Done done) const;
  [[nodiscard]] std::shared_ptr<const std::vector<CellId>> assigned() const;

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
