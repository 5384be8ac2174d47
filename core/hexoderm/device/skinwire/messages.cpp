#include "hexoderm/device/skinwire/messages.h"

#include "hexoderm/base/joint_angles.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <set>
#include <utility>

namespace hexoderm::skinwire {
namespace {

constexpr std::size_t kMaxText = 1000;
constexpr std::size_t kMaxModelText = 65536;
constexpr int kMaxRate = 1'000'000;
constexpr double kMaxRate_hz = kMaxRate;

ValidationError wrongValue(const char* field, hexoderm::Message what) {
  return {ProtocolViolationKind::WrongValue, located(field, std::move(what))};
}
ValidationError wrongLength(const char* field, hexoderm::Message what) {
  return {ProtocolViolationKind::WrongLength, located(field, std::move(what))};
}

/// The first that says something.
ValidationError firstOf(std::initializer_list<ValidationError> complaints) {
  for (const ValidationError& one : complaints) {
    if (!one.empty()) return one;
  }
  return {};
}

ValidationError wrongSize(const char* field, std::size_t expected, std::size_t found) {
  if (expected == found) return {};
  return wrongLength(field, message("expected {} numbers, found {}", expected, found));
}

ValidationError tooLong(const char* field, const std::string& text, std::size_t most) {
  if (text.size() <= most) return {};
  return wrongLength(field, message("expected at most {} bytes, found {}", most, text.size()));
}

ValidationError notFinite(const char* field, const std::vector<float>& values) {
  const bool are_finite = std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
  return are_finite ? ValidationError{} : wrongValue(field, message("expected finite numbers"));
}

ValidationError complain(const Hello& hello) {
  if (hello.cell_model.empty()) {
    return wrongValue("hello.cell_model",
                      message("expected a built-in model's name or a model as JSON text, found nothing"));
  }
  if (!(hello.rate_hz >= 0 && hello.rate_hz <= kMaxRate_hz)) {
    return wrongValue("hello.rate_hz", message("expected 0 to {}", kMaxRate));
  }
  return firstOf(
      {tooLong("hello.device", hello.device, kMaxText), tooLong("hello.cell_model", hello.cell_model, kMaxModelText)});
}

ValidationError complain(const Topology& topology) {
  if (topology.parts < 1 || topology.parts > kMaxCells) {
    return wrongValue("topology.parts", message("expected 1 to {}", kMaxCells));
  }
  if (topology.part >= topology.parts) {
    return wrongValue("topology.part",
                      message("expected less than parts ({}), found {}", topology.parts, topology.part));
  }
  if (topology.cells.size() > kMaxCells) {
    return wrongLength("topology.cells", message("expected at most {} cells", kMaxCells));
  }
  for (const CellReport& cell : topology.cells) {
    if (ValidationError why = tooLong("topology.cells.body_part", cell.body_part, kMaxText); !why.empty()) return why;
  }
  return {};
}

ValidationError complainOfMeans(const Samples& samples, std::size_t per_tick) {
  const ValidationError why =
      firstOf({wrongSize("samples.mean_g", per_tick, samples.mean_g.size()),
               wrongSize("samples.variance_g2", per_tick, samples.variance_g2.size()),
               wrongSize("samples.count", samples.cells.size(), samples.count.size()),
               notFinite("samples.mean_g", samples.mean_g), notFinite("samples.variance_g2", samples.variance_g2)});
  if (!why.empty()) return why;
  if (std::ranges::any_of(samples.variance_g2, [](float v) { return v < 0; })) {
    return wrongValue("samples.variance_g2", message("expected numbers of at least 0"));
  }
  if (std::ranges::any_of(samples.count, [](std::uint32_t n) { return n == 0; })) {
    return wrongValue("samples.count", message("expected at least 1"));
  }
  return {};
}

ValidationError complainOfValues(const Samples& samples) {
  const std::size_t per_tick = 3 * samples.cells.size();
  const int kinds =
      (samples.raw_lsb.empty() ? 0 : 1) + (samples.acceleration_g.empty() ? 0 : 1) + (samples.mean_g.empty() ? 0 : 1);
  if (samples.cells.empty() && kinds > 0) {
    return wrongLength("samples.cells", message("expected the IDs of the cells that the readings are of, found none"));
  }
  if (!samples.cells.empty() && kinds != 1) {
    return wrongLength(
        "samples", message("expected exactly one of raw_lsb, acceleration_g and mean_g with cells, found {}", kinds));
  }
  if (!samples.mean_g.empty()) return complainOfMeans(samples, per_tick);
  if (!samples.variance_g2.empty() || !samples.count.empty()) {
    return wrongLength("samples", message("variance_g2 and count belong to mean_g, which is not there"));
  }
  const std::size_t values = samples.raw_lsb.size() + samples.acceleration_g.size();
  if (per_tick != 0 && values % per_tick != 0) {
    return wrongLength(
        samples.raw_lsb.empty() ? "samples.acceleration_g" : "samples.raw_lsb",
        message("expected a multiple of 3 numbers for each of {} cells, found {}", samples.cells.size(), values));
  }
  return notFinite("samples.acceleration_g", samples.acceleration_g);
}

ValidationError complain(const Samples& samples) {
  const ValidationError why =
      firstOf({complainOfValues(samples),
               wrongSize("samples.temperature_c", samples.temperature_cells.size(), samples.temperature_c.size()),
               notFinite("samples.temperature_c", samples.temperature_c)});
  if (!why.empty()) return why;
  const std::size_t ticks = samples.ticks();
  if (ticks > 1 && samples.period_us == 0) {
    return wrongValue("samples.period_us", message("expected at least 1 between several ticks ({} here)", ticks));
  }
  const std::uint64_t span_us = ticks > 1 ? (ticks - 1) * std::uint64_t{samples.period_us} : 0;
  if (samples.time_us > kMaxTime_us || span_us > kMaxTime_us - samples.time_us) {
    return wrongValue("samples.time_us", message("expected at most 2^53"));
  }
  // A sequence near the end of its range would overflow in the sum with the samples that follow.
  if (samples.sequence && *samples.sequence > kMaxTime_us) {
    return wrongValue("samples.sequence", message("expected at most 2^53"));
  }
  return {};
}

ValidationError complain(const Status& status) { return tooLong("status.text", status.text, kMaxText); }

ValidationError complain(const Command& command) {
  if (const auto* rate = std::get_if<SetRate>(&command.request)) {
    if (!(rate->rate_hz > 0 && rate->rate_hz <= kMaxRate_hz)) {
      return wrongValue("set_rate.rate_hz", message("expected above 0, up to {}", kMaxRate));
    }
  } else if (const auto* turn = std::get_if<TurnTo>(&command.request)) {
    constexpr double kTolerance = 1e-3;
    if (!(std::abs(turn->up_u.norm() - 1) <= kTolerance)) {
      return wrongValue("turn_to.up", message("expected a unit vector"));
    }
  }
  return {};
}

ValidationError complain(const Ack& ack) {
  if (ack.done && ack.working) return wrongValue("ack", message("expected done or working, found both"));
  return tooLong("ack.text", ack.text, kMaxText);
}

ValidationError complain(const Joints& joints) {
  if (joints.time_us > kMaxTime_us) return wrongValue("joints.time_us", message("expected at most 2^53"));
  if (joints.position.empty() || joints.position.size() > kMaxJoints) {
    return wrongLength("joints.position",
                       message("expected 1 to {} numbers, found {}", kMaxJoints, joints.position.size()));
  }
  if (!joints.names.empty()) {
    if (ValidationError why = wrongSize("joints.position", joints.names.size(), joints.position.size()); !why.empty()) {
      return why;
    }
  }
  std::set<std::string_view> names;
  for (const std::string& name : joints.names) {
    if (ValidationError why = tooLong("joints.names", name, kMaxText); !why.empty()) return why;
    if (name.empty()) return wrongValue("joints.names", message("expected the name of a joint, found nothing"));
    if (!names.insert(name).second) return wrongValue("joints.names", message("expected each joint once"));
  }
  const auto isPosition = [](double position) { return std::abs(position) <= kMaxJointPosition; };  // NaN is none
  if (!std::ranges::all_of(joints.position, isPosition)) {
    return wrongValue("joints.position", message("expected finite numbers, at most {}", Number{kMaxJointPosition, 0}));
  }
  return {};
}

}  // namespace

std::size_t Samples::ticks() const {
  if (cells.empty()) return 0;
  return mean_g.empty() ? (raw_lsb.size() + acceleration_g.size()) / (3 * cells.size()) : 1;
}

ValidationError complaint(const Message& message) {
  return std::visit([](const auto& m) { return complain(m); }, message);
}

}  // namespace hexoderm::skinwire
