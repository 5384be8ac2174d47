#include "hexoderm/device/skinwire/messages.h"

#include <algorithm>
#include <cmath>

namespace hexoderm::skinwire {
namespace {

constexpr std::size_t kMaxText = 1000;
constexpr std::size_t kMaxModelText = 65536;
constexpr double kMaxRate_hz = 1e6;

bool allFinite(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); });
}

/// "what: expected N numbers, found M", or nothing.
std::string wrongSize(const char* what, std::size_t expected, std::size_t found) {
  if (expected == found) return {};
  return std::string(what) + ": expected " + std::to_string(expected) + " numbers, found " + std::to_string(found);
}

std::string tooLong(const char* what, const std::string& text, std::size_t most) {
  if (text.size() <= most) return {};
  return std::string(what) + ": expected at most " + std::to_string(most) + " bytes, found " +
         std::to_string(text.size());
}

std::string complain(const Hello& hello) {
  if (auto why = tooLong("device", hello.device, kMaxText); !why.empty()) return why;
  if (hello.cell_model.empty()) return "cell_model: expected a built-in model's name or a model as JSON, found nothing";
  if (auto why = tooLong("cell_model", hello.cell_model, kMaxModelText); !why.empty()) return why;
  if (!(hello.rate_hz >= 0 && hello.rate_hz <= kMaxRate_hz)) return "rate_hz: expected 0 to 1,000,000";
  return {};
}

std::string complain(const Topology& topology) {
  if (topology.parts < 1 || topology.parts > kMaxCells) return "parts: expected 1 to " + std::to_string(kMaxCells);
  if (topology.part >= topology.parts) {
    return "part: expected less than parts (" + std::to_string(topology.parts) + "), found " +
           std::to_string(topology.part);
  }
  if (topology.cells.size() > kMaxCells) return "cells: expected at most " + std::to_string(kMaxCells);
  for (const CellReport& cell : topology.cells) {
    if (auto why = tooLong("body_part", cell.body_part, kMaxText); !why.empty()) return why;
  }
  return {};
}

std::string complainOfValues(const Samples& samples) {
  const std::size_t per_tick = 3 * samples.cells.size();
  const int kinds =
      (samples.raw_lsb.empty() ? 0 : 1) + (samples.acceleration_g.empty() ? 0 : 1) + (samples.mean_g.empty() ? 0 : 1);
  if (kinds != (samples.cells.empty() ? 0 : 1)) {
    return "expected exactly one of raw_lsb, acceleration_g and mean_g with cells, and none without, found " +
           std::to_string(kinds);
  }
  if (samples.mean_g.empty()) {
    if (!samples.variance_g2.empty() || !samples.count.empty()) return "variance_g2 and count belong to mean_g";
    const std::size_t values = samples.raw_lsb.size() + samples.acceleration_g.size();
    if (per_tick != 0 && values % per_tick != 0) {
      return "expected a multiple of 3 numbers for each of " + std::to_string(samples.cells.size()) + " cells, found " +
             std::to_string(values);
    }
    return allFinite(samples.acceleration_g) ? "" : "acceleration_g: expected finite numbers";
  }
  if (auto why = wrongSize("mean_g", per_tick, samples.mean_g.size()); !why.empty()) return why;
  if (auto why = wrongSize("variance_g2", per_tick, samples.variance_g2.size()); !why.empty()) return why;
  if (auto why = wrongSize("count", samples.cells.size(), samples.count.size()); !why.empty()) return why;
  if (!allFinite(samples.mean_g) || !allFinite(samples.variance_g2)) {
    return "mean_g and variance_g2: expected finite numbers";
  }
  if (std::any_of(samples.variance_g2.begin(), samples.variance_g2.end(), [](float v) { return v < 0; })) {
    return "variance_g2: expected numbers of at least 0";
  }
  if (std::any_of(samples.count.begin(), samples.count.end(), [](std::uint32_t n) { return n == 0; })) {
    return "count: expected at least 1";
  }
  return {};
}

std::string complain(const Samples& samples) {
  if (auto why = complainOfValues(samples); !why.empty()) return why;
  if (auto why = wrongSize("temperature_c", samples.temperature_cells.size(), samples.temperature_c.size());
      !why.empty()) {
    return why;
  }
  if (!allFinite(samples.temperature_c)) return "temperature_c: expected finite numbers";
  const std::size_t ticks = samples.ticks();
  if (ticks > 1 && samples.period_us == 0) return "period_us: expected at least 1 between several ticks";
  const std::uint64_t span_us = ticks > 1 ? (ticks - 1) * std::uint64_t{samples.period_us} : 0;
  if (samples.time_us > kMaxTime_us || span_us > kMaxTime_us - samples.time_us) return "time_us: expected at most 2^53";
  // A sequence near the end of its range would overflow in the sum with the samples that follow.
  if (samples.sequence && *samples.sequence > kMaxTime_us) return "sequence: expected at most 2^53";
  return {};
}

std::string complain(const Status& status) { return tooLong("text", status.text, kMaxText); }

std::string complain(const Command& command) {
  if (const auto* rate = std::get_if<SetRate>(&command.request)) {
    if (!(rate->rate_hz > 0 && rate->rate_hz <= kMaxRate_hz)) return "rate_hz: expected above 0, up to 1,000,000";
  } else if (const auto* turn = std::get_if<TurnTo>(&command.request)) {
    constexpr double kTolerance = 1e-3;
    if (!(std::abs(turn->up_u.norm() - 1) <= kTolerance)) return "up: expected a unit vector";
  }
  return {};
}

std::string complain(const Ack& ack) {
  if (ack.done && ack.working) return "expected done or working, found both";
  return tooLong("text", ack.text, kMaxText);
}

}  // namespace

std::size_t Samples::ticks() const {
  if (cells.empty()) return 0;
  return mean_g.empty() ? (raw_lsb.size() + acceleration_g.size()) / (3 * cells.size()) : 1;
}

std::string complaint(const Message& message) {
  return std::visit([](const auto& m) { return complain(m); }, message);
}

}  // namespace hexoderm::skinwire
