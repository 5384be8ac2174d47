#pragma once

#include "hexoderm/device/sample_frame.h"
#include "hexoderm/device/skin_source.h"
#include "hexoderm/device/skinwire/messages.h"

#include <span>
#include <string>
#include <vector>

namespace hexoderm::skinwire {

/// Turns what a skin delivers into messages, and counts its samples.
class SampleEncoder {
 public:
  /// `lsb_g` of the cell model's accelerometer. Readings that are exact multiples of it go as LSB, others as float, so
  /// that a quantised skin is carried without loss. `max_body` bounds every message's body, bytes.
  explicit SampleEncoder(double lsb_g, std::size_t max_body = kMaxBody) : lsb_g_(lsb_g), max_body_(max_body) {}

  /// Appends the messages of one frame, each of one tick. Values that are not finite are left out with their cell.
  /// Throws InvalidArgument if the time is negative or too large.
  void encode(const SampleFrame& frame, std::vector<Samples>& out);

  /// Encodes several consecutive frames: in a single message if they have samples of the same cells and nothing else,
  /// are equally spaced and fit; else one by one.
  void encodeBatch(std::span<const SampleFrame> frames, std::vector<Samples>& out);

  /// Samples encoded so far: the next message's number.
  [[nodiscard]] std::uint64_t sequence() const { return sequence_; }

 private:
  void append(Samples message, std::vector<Samples>& out);

  double lsb_g_;
  std::size_t max_body_;
  std::uint64_t sequence_ = 0;
};

/// Turns what a robot says about its joints into messages: with their names at first, and whenever they change.
class JointsEncoder {
 public:
  /// Of at least one joint. A time before 0 becomes 0.
  Joints encode(const JointReport& report);
  /// The next message has the names again, as after a description.
  void nameAgain() { names_.clear(); }

 private:
  std::vector<std::string> names_;  ///< as said last
};

/// One tick of a message as a frame. `frame` is used again, so that its arrays need not grow each time. `tick` is below
/// message.ticks(); temperatures come with tick 0, also where there are no cells. The message must have no complaint.
void decodeTick(const Samples& message, std::size_t tick, double lsb_g, SampleFrame& frame);

}  // namespace hexoderm::skinwire
