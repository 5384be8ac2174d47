#pragma once

// A skin of three cells in a row that does everything right, and devices that each do one thing wrong. Simulated: their
// readings are made here.

#include "hexoderm/device/protocol_violation.h"
#include "hexoderm/device/skinwire/codec.h"

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hexoderm {

/// What a device sends, before somebody gets it wrong.
struct Device {
  using Json = nlohmann::json;
  Json hello;
  Json topology;
  std::vector<Json> samples;
  std::vector<Json> more;                             ///< whole lines, sent after the samples
  std::function<std::string(std::string)> as_sent{};  ///< of all lines, in place of the lines themselves

  /// Three seconds of three cells at 100 Hz, at rest with a noise of 4 mg.
  static Device right();
  [[nodiscard]] std::string lines() const;
  /// `change` of every message of samples.
  void eachSamples(const std::function<void(Json&)>& change);
  /// All readings times this.
  void scale(double factor);
  /// The frames of bytes of the same messages: length in front.
  [[nodiscard]] std::string frames() const;
};

struct WrongDevice {
  const char* name;
  std::function<void(Device&)> spoil;
  ProtocolViolationKind kind;
  const char* words;      ///< in the reason
  bool is_ready = false;  ///< a calibration could begin all the same
};

/// One a line.
const std::vector<WrongDevice>& wrongDevices();

}  // namespace hexoderm
