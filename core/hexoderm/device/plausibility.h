#pragma once

#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/device/sample_frame.h"
#include "hexoderm/skin/cell_model.h"

#include <Eigen/Geometry>
#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace hexoderm {

/// What is wrong with readings whose norm is `median_norm` in the median, of cells that feel gravity (1 g) and a hand's
/// motion at most. AccelerationUnit if it is that of gravity in another unit (m/s^2, mg, LSB), NotGravity if it is
/// below 0.5 or above 2; nullopt if it may be g. `field` is where the readings were found.
std::optional<ProtocolViolation> offenceOfNorm(double median_norm, const Accelerometer& accelerometer,
                                               const char* field);

/// Judges the norms of the readings that come, of up to 64 cells of every fourth frame. That they are no gravity counts
/// only where the part is still: whoever swings it adds a force of any size.
class ReadingCheck {
 public:
  /// Of one cell.
  struct SampleRange {
    Eigen::AlignedBox3d box_g;
    std::uint32_t samples = 0;
  };
  /// An offence as soon as enough readings say the same. `field`: where the readings were found.
  std::optional<ProtocolViolation> add(const SampleFrame& frame, const Accelerometer& accelerometer, const char* field);

 private:
  std::uint64_t frames_ = 0;
  std::uint32_t looked_at_ = 0;  ///< frames in norms_g_
  std::uint32_t in_row_ = 0;     ///< judgements that found no gravity
  std::vector<double> norms_g_;
  std::map<CellId, SampleRange> ranges_;
};

/// Compares a device's clock with the rate that it states and with the host's clock: a step that is a thousand times
/// too small or too large is of another unit.
class ClockCheck {
 public:
  using Clock = std::chrono::steady_clock;

  /// The time of a cell's sample (no mean), which came after its last one. `stated_hz`: the rate by the device, 0: not
  /// known; `sensor_hz`: that of the cell model's accelerometer, which delivers no quicker.
  /// `is_whole`: no sample was lost on the way, so that the steps are those of the device.
  std::optional<ProtocolViolation> addSample(CellId cell, std::uint64_t time_us, double stated_hz, double sensor_hz,
                                             bool is_whole);
  /// How fast a device's times come.
  enum class Pace {
    Live,    ///< as its clock runs
    Faster,  ///< so, or faster: a file in a pipe
    Free,    ///< as somebody plays them
  };
  /// The last time that came, and the host's time now.
  std::optional<ProtocolViolation> compare(std::uint64_t last_us, Clock::time_point now, Pace pace);

 private:
  std::optional<CellId> cell_;  ///< whose steps are looked at
  std::uint64_t first_us_ = 0;
  std::uint32_t steps_ = 0;

  struct Moment {
    std::uint64_t device_us = 0;
    Clock::time_point host;
  };
  static double hostPerDevice(const Moment& from, const Moment& to);
  std::optional<Moment> began_;
  Moment last_;
  std::uint32_t changes_ = 0;  ///< in a row, each as if of another unit
};

}  // namespace hexoderm
