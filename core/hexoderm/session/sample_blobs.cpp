#include "hexoderm/session/sample_blobs.h"

#include "hexoderm/base/error.h"
#include "hexoderm/base/rounding.h"
#include "hexoderm/session/storable.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace hexoderm {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes of a store are little-endian");
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<float>::is_iec559);

/// cell, count, flags, nothing, mean (3), covariance (xx, xy, xz, yy, yz, zz), temperature
constexpr std::size_t kSampleBytes = 4 * sizeof(std::uint32_t) + 10 * sizeof(double);
constexpr std::uint32_t kHasTemperature = 1;
/// Flag in a count of samples: their cells are those of the frame before.
constexpr std::uint32_t kSameCells = 1U << 31U;
constexpr int kMaxSteps = std::numeric_limits<std::int16_t>::max();

/// Numbers one after another, as they stand in memory; quickest within the room that is made for them beforehand.
class Writer {
 public:
  explicit Writer(std::size_t bytes) { bytes_.reserve(bytes); }
  template <class T>
  void put(T value) {
    const auto* const first = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof(T));
  }
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

class Reader {
 public:
  Reader(std::span<const std::uint8_t> bytes, const std::string& where) : rest_(bytes), where_(where) {}
  template <class T>
  T get() {
    if (rest_.size() < sizeof(T)) fail(message("the data end in the middle"));
    T value;
    std::memcpy(&value, rest_.data(), sizeof(T));
    rest_ = rest_.subspan(sizeof(T));
    return value;
  }
  /// A count of items that take at least so many bytes each: no more than there can be.
  std::uint32_t count(std::size_t bytes_each) {
    const auto count = get<std::uint32_t>();
    if (count > rest_.size() / bytes_each) fail(message("the data end in the middle"));
    return count;
  }
  double finite(bool is_short) {
    const double value = is_short ? static_cast<double>(get<float>()) : get<double>();
    if (!std::isfinite(value)) fail(message("expected finite numbers"));
    return value;
  }
  [[nodiscard]] bool atEnd() const { return rest_.empty(); }
  [[noreturn]] void fail(const Message& what) const { throw FormatError(where_, what); }

 private:
  std::span<const std::uint8_t> rest_;
  const std::string& where_;
};

Eigen::Vector3d readVector(Reader& in, bool is_short) {
  Eigen::Vector3d v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = in.finite(is_short);
  return v;
}

/// The frame that the samples of the next one may refer to.
struct FrameBefore {
  const std::vector<CellSample>* samples = nullptr;  ///< null: there is none
  std::vector<int> steps;                            ///< numbers in steps, three a sample, if the step is known
};

/// Takes the cells of the frame before where `count` says so, and returns whether it does.
bool takeCells(const Reader& in, std::uint32_t count, const FrameBefore& before, std::vector<CellSample>& samples) {
  if ((count & kSameCells) == 0) return false;
  if (before.samples == nullptr || before.samples->size() != (count & ~kSameCells)) {
    in.fail(message("raw samples: expected cells"));
  }
  samples = *before.samples;
  return true;
}

// Samples grow as they are read: the count may be a lie.

void readNumbers(Reader& in, std::uint32_t count, bool is_short, const FrameBefore& before,
                 std::vector<CellSample>& samples) {
  if (takeCells(in, count, before, samples)) {
    for (CellSample& sample : samples) sample.acceleration_g = readVector(in, is_short);
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const CellId cell(in.get<std::uint32_t>());
    samples.push_back({cell, readVector(in, is_short)});
  }
}

void readSteps(Reader& in, std::uint32_t count, double step, FrameBefore& before, std::vector<CellSample>& samples) {
  const bool are_differences = takeCells(in, count, before, samples);
  if (!are_differences) {
    before.steps.clear();
    for (std::uint32_t i = 0; i < count; ++i) {
      samples.push_back({CellId(in.get<std::uint32_t>()), Eigen::Vector3d::Zero()});
    }
    before.steps.assign(3 * samples.size(), 0);
  }
  std::size_t k = 0;
  for (CellSample& sample : samples) {
    for (double& value : sample.acceleration_g) {
      int& steps = before.steps[k++];
      steps += are_differences ? int{in.get<std::int8_t>()} : int{in.get<std::int16_t>()};
      if (std::abs(steps) > kMaxSteps) in.fail(message("expected readings of at most 32767 steps"));
      value = steps * step;
      if (!std::isfinite(value)) in.fail(message("expected finite numbers"));
    }
  }
}

/// Calls `visit` with every number of the frames except the times.
template <class Visit>
void forEachNumber(std::span<const SampleFrame> frames, Visit visit) {
  for (const SampleFrame& frame : frames) {
    for (const CellSample& sample : frame.samples) {
      for (const double value : sample.acceleration_g) visit(value);
    }
    for (const CellMean& mean : frame.means) {
      for (const double value : mean.mean_g) visit(value);
      for (const double value : mean.variance_g2) visit(value);
    }
    for (const CellTemperature& temperature : frame.temperatures) visit(temperature.temperature_c);
  }
}

/// Too large a number for a float is not converted, which would be undefined.
bool isExactAsFloat(double value) {
  return std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max()) &&
         std::bit_cast<std::uint64_t>(static_cast<double>(static_cast<float>(value))) ==
             std::bit_cast<std::uint64_t>(value);
}

std::uint32_t countOf(std::size_t size) {
  if (size >= kSameCells) throw InvalidArgument(message("raw samples: too many for one pose"));
  return static_cast<std::uint32_t>(size);
}

/// The part of a frame that is not samples.
template <class Put>
void putRest(const SampleFrame& frame, Put put, Writer& out) {
  for (const CellMean& mean : frame.means) {
    out.put(mean.cell.value());
    out.put(mean.count);
    for (const double value : mean.mean_g) put(value);
    for (const double value : mean.variance_g2) put(value);
  }
  for (const CellTemperature& temperature : frame.temperatures) {
    out.put(temperature.cell.value());
    put(temperature.temperature_c);
  }
}

/// The reading in steps if it comes back as the same double.
std::optional<std::int16_t> exactSteps(double value, double step) {
  const double steps = nearestWhole(value / step);
  if (!(std::abs(steps) <= std::numeric_limits<std::int16_t>::max())) return std::nullopt;
  if (std::bit_cast<std::uint64_t>(steps * step) != std::bit_cast<std::uint64_t>(value)) return std::nullopt;
  return static_cast<std::int16_t>(steps);
}

bool hasCellsOfFrameBefore(std::span<const SampleFrame> frames, std::size_t k) {
  return k > 0 &&
         std::ranges::equal(frames[k].samples, frames[k - 1].samples, {}, &CellSample::cell, &CellSample::cell);
}

void putHead(const SampleFrame& frame, bool without_cells, Writer& out) {
  out.put(frame.time_s);
  out.put(countOf(frame.samples.size()) | (without_cells ? kSameCells : 0U));
  out.put(countOf(frame.means.size()));
  out.put(countOf(frame.temperatures.size()));
}

/// Nothing if a reading is no whole number of steps.
std::optional<Bytes> encodeSteps(std::span<const SampleFrame> frames, double step) {
  Writer out(mostBytesOf(frames));
  out.put(std::uint32_t{2});
  out.put(countOf(frames.size()));
  out.put(step);
  std::vector<std::int16_t> before;
  std::vector<std::int16_t> now;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const SampleFrame& frame = frames[k];
    now.clear();
    for (const CellSample& sample : frame.samples) {
      for (const double value : sample.acceleration_g) {
        const std::optional<std::int16_t> steps = exactSteps(value, step);
        if (!steps) return std::nullopt;
        now.push_back(*steps);
      }
    }
    const auto isNear = [](std::int16_t a, std::int16_t b) { return std::abs(a - b) <= INT8_MAX; };
    const bool as_differences = hasCellsOfFrameBefore(frames, k) && std::ranges::equal(now, before, isNear);
    putHead(frame, as_differences, out);
    if (as_differences) {
      for (std::size_t n = 0; n < now.size(); ++n) out.put(static_cast<std::int8_t>(now[n] - before[n]));
    } else {
      for (const CellSample& sample : frame.samples) out.put(sample.cell.value());
      for (const std::int16_t steps : now) out.put(steps);
    }
    putRest(
        frame, [&](double value) { out.put(value); }, out);
    now.swap(before);
  }
  return out.take();
}

}  // namespace

std::size_t mostBytesOf(std::span<const SampleFrame> frames) {
  std::size_t bytes = 16;
  for (const SampleFrame& frame : frames) {
    bytes += 20 + 28 * frame.samples.size() + 56 * frame.means.size() + 12 * frame.temperatures.size();
  }
  return bytes;
}

Bytes encodeSamples(std::span<const GravitySample> samples) {
  Writer out(samples.size() * kSampleBytes);
  for (const GravitySample& sample : samples) {
    requireStorable(sample);
    out.put(sample.cell.value());
    out.put(sample.count);
    out.put(sample.temperature_c ? kHasTemperature : 0U);
    out.put(std::uint32_t{0});
    for (const double value : sample.mean_g) out.put(value);
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) out.put(sample.cov_g2(row, column));
    }
    out.put(sample.temperature_c.value_or(0.0));
  }
  return out.take();
}

std::vector<GravitySample> decodeSamples(std::span<const std::uint8_t> bytes, const std::string& where) {
  Reader in(bytes, where);
  if (bytes.size() % kSampleBytes != 0) {
    in.fail(message("samples: expected {} bytes for each cell, found {} bytes", kSampleBytes, bytes.size()));
  }
  std::vector<GravitySample> samples(bytes.size() / kSampleBytes);
  for (GravitySample& sample : samples) {
    sample.cell = CellId(in.get<std::uint32_t>());
    sample.count = in.get<std::uint32_t>();
    const auto flags = in.get<std::uint32_t>();
    if ((flags & ~kHasTemperature) != 0 || in.get<std::uint32_t>() != 0) {
      in.fail(message("samples: cell {}: expected no other flags than 1 (has a temperature)", sample.cell));
    }
    for (double& value : sample.mean_g) value = in.get<double>();
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        sample.cov_g2(row, column) = sample.cov_g2(column, row) = in.get<double>();
      }
    }
    const auto temperature_c = in.get<double>();
    if (flags == kHasTemperature) sample.temperature_c = temperature_c;
    if (const Message problem = problemOf(sample); !problem.empty()) {
      in.fail(message("samples: cell {}: {}", sample.cell, problem));
    }
  }
  return samples;
}

Bytes encodeFrames(std::span<const SampleFrame> frames, double lsb_g) {
  bool is_short = true;
  forEachNumber(frames, [&](double value) {
    if (!std::isfinite(value)) throw InvalidArgument(message("raw samples: must be finite to be stored"));
    is_short = is_short && isExactAsFloat(value);
  });
  for (const SampleFrame& frame : frames) {
    if (!std::isfinite(frame.time_s)) throw InvalidArgument(message("raw samples: times must be finite to be stored"));
  }
  if (lsb_g > 0) {
    if (std::optional<Bytes> bytes = encodeSteps(frames, lsb_g)) return std::move(*bytes);
  }
  Writer out(mostBytesOf(frames));
  const auto put = [&](double value) { is_short ? out.put(static_cast<float>(value)) : out.put(value); };
  out.put(is_short ? 4U : 8U);
  out.put(countOf(frames.size()));
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const SampleFrame& frame = frames[k];
    const bool same = hasCellsOfFrameBefore(frames, k);
    putHead(frame, same, out);
    for (const CellSample& sample : frame.samples) {
      if (!same) out.put(sample.cell.value());
      for (const double value : sample.acceleration_g) put(value);
    }
    putRest(frame, put, out);
  }
  return out.take();
}

std::vector<SampleFrame> decodeFrames(std::span<const std::uint8_t> bytes, const std::string& where) {
  Reader in(bytes, where);
  const auto width = in.get<std::uint32_t>();
  if (width != 2 && width != 4 && width != 8) in.fail(message("raw samples: expected numbers of 2, 4 or 8 bytes"));
  const bool is_short = width == 4;
  constexpr std::size_t kFrameBytes = 20;
  const std::uint32_t count = in.count(kFrameBytes);
  const double step = width == 2 ? in.finite(false) : 0;
  std::vector<SampleFrame> frames(count);
  FrameBefore before;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    SampleFrame& frame = frames[k];
    frame.time_s = in.finite(false);
    const auto samples = in.get<std::uint32_t>();
    const auto means = in.get<std::uint32_t>();
    const auto temperatures = in.get<std::uint32_t>();
    if (k > 0) before.samples = &frames[k - 1].samples;
    if (width == 2) {
      readSteps(in, samples, step, before, frame.samples);
    } else {
      readNumbers(in, samples, is_short, before, frame.samples);
    }
    for (std::uint32_t i = 0; i < means; ++i) {
      CellMean mean;
      mean.cell = CellId(in.get<std::uint32_t>());
      mean.count = in.get<std::uint32_t>();
      mean.mean_g = readVector(in, is_short);
      mean.variance_g2 = readVector(in, is_short);
      frame.means.push_back(mean);
    }
    for (std::uint32_t i = 0; i < temperatures; ++i) {
      const CellId cell(in.get<std::uint32_t>());
      frame.temperatures.push_back({cell, in.finite(is_short)});
    }
  }
  if (!in.atEnd()) in.fail(message("raw samples: expected the end, found more data"));
  return frames;
}

}  // namespace hexoderm
