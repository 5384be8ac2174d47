#pragma once

#include "hexoderm/device/skin_source.h"

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hexoderm {

/// Least, median and largest of some figures.
struct Spread {
  double least = 0;
  double median = 0;
  double most = 0;
};

/// What was heard of one cell.
struct CellHeard {
  CellId cell;
  std::uint64_t readings = 0;       ///< samples and means
  std::optional<double> rate_hz{};  ///< readings per second of the device's time; from two on
  std::optional<Spread> norm_g{};   ///< of the readings
  /// Mean of the readings along the axes of the cell, as its model places the accelerometer.
  std::optional<Eigen::Vector3d> mean_u{};
  /// Standard deviation of one sample per axis, g: of the steps between consecutive samples, so that a slow turn does
  /// not count, or of what the device says beside its means. From ten readings on.
  std::optional<double> noise_g{};
};

/// A time of listening to a device, judged as the maker of that device needs it.
struct ListeningReport {
  bool is_described = false;
  std::string device;
  std::string cell_model;
  std::vector<CellHeard> cells;      ///< those of the topology, in its order, without interfaces
  std::vector<CellId> silent_cells;  ///< without a reading
  std::optional<Spread> rate_hz;     ///< over the cells
  std::optional<Spread> norm_g;      ///< over all readings
  std::optional<Spread> noise_g;     ///< over the cells
  /// How many times slower than the device's clock its readings arrive, on the whole; from 2 s on. A line that is too
  /// slow, behind a buffer, has 3 where it carries a third of what is sent.
  std::optional<double> slowness;
  std::size_t links_agreed = 0;             ///< which both ends report
  std::size_t links_one_sided = 0;          ///< which only one end reports
  std::size_t links_unusable = 0;           ///< left out for another reason
  std::vector<ProtocolViolation> offences;  ///< the first of each kind
  SourceStatus status;                      ///< counters at the end
  /// Why no calibration could begin; empty if one could: two joined cells send readings in g with times in
  /// microseconds.
  Message obstacle;
  std::vector<Message> remarks;  ///< on what is no offence and hinders no calibration
};

/// Listens to a source, and reports. Belongs to the source's thread until the source has stopped.
class Listening final : public SkinListener {
 public:
  void onSkin(const SkinDescription& skin) override;
  using Clock = std::chrono::steady_clock;  ///< the host's

  void onFrame(const SampleFrame& frame) override { add(frame, Clock::now()); }
  void add(const SampleFrame& frame, Clock::time_point now);  ///< a frame that arrives at the host's time `now`
  void onStatus(const SourceStatus& status) override { status_ = status; }
  void onCommandOutcome(const CommandOutcome& /*outcome*/) override {}

  [[nodiscard]] ListeningReport report() const;  ///< what was found until now

 private:
  struct Cell {
    std::uint64_t readings = 0;
    Eigen::Vector3d sum_g = Eigen::Vector3d::Zero();  ///< along the accelerometer's axes
    double last_s = 0;
    double elapsed_s = 0;  ///< over the intervals
    std::uint64_t intervals = 0;
    std::optional<Eigen::Vector3d> last_g;
    double step_sum_g2 = 0;  ///< of squared steps over the axes
    std::uint64_t steps = 0;
    double variance_sum_g2 = 0;  ///< of those that the device gives, over the axes
    std::uint64_t variances = 0;
    std::vector<float> norms_g;  ///< of every stride-th reading
    std::uint64_t stride = 1;
  };
  static void addReading(Cell& cell, const Eigen::Vector3d& acceleration_g, double time_s);
  void judge(ListeningReport& report) const;
  void remark(ListeningReport& report) const;

  std::optional<SkinDescription> skin_;
  std::map<CellId, Cell> cells_;
  SourceStatus status_;
  bool has_means_ = false;
  std::optional<double> last_s_;  ///< of the frame before, and when it arrived
  Clock::time_point last_arrival_;
  double device_s_ = 0;  ///< over the steps between frames by which the device's clock went on
  double host_s_ = 0;    ///< over the same steps
};

}  // namespace hexoderm
