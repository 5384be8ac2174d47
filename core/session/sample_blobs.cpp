#include "sample_blobs.h"

#include "hexoderm/util/error.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace hexoderm {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes of a store are little-endian");
static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<float>::is_iec559);

/// cell, count, flags, nothing, mean (3), covariance (xx, xy, xz, yy, yz, zz), temperature
constexpr std::size_t kSampleBytes = 4 * sizeof(std::uint32_t) + 10 * sizeof(double);
constexpr std::uint32_t kHasTemperature = 1;

class Writer {
 public:
  explicit Writer(std::size_t size) { bytes_.reserve(size); }
  template <class T>
  void put(T value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(T));
    std::memcpy(bytes_.data() + at, &value, sizeof(T));
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
    if (rest_.size() < sizeof(T)) fail("the data end in the middle");
    T value;
    std::memcpy(&value, rest_.data(), sizeof(T));
    rest_ = rest_.subspan(sizeof(T));
    return value;
  }
  /// A count of items that take at least so many bytes each: no more than there can be.
  std::uint32_t count(std::size_t bytes_each) {
    const auto count = get<std::uint32_t>();
    if (count > rest_.size() / bytes_each) fail("the data end in the middle");
    return count;
  }
  double finite(bool is_short) {
    const double value = is_short ? static_cast<double>(get<float>()) : get<double>();
    if (!std::isfinite(value)) fail("expected finite numbers");
    return value;
  }
  [[nodiscard]] bool atEnd() const { return rest_.empty(); }
  [[noreturn]] void fail(const std::string& what) const { throw FormatError(where_ + ": " + what); }

 private:
  std::span<const std::uint8_t> rest_;
  const std::string& where_;
};

Eigen::Vector3d readVector(Reader& in, bool is_short) {
  Eigen::Vector3d v;
  for (int axis = 0; axis < 3; ++axis) v[axis] = in.finite(is_short);
  return v;
}

/// What is wrong with a sample, or null.
const char* problemOf(const GravitySample& sample) {
  if (!sample.mean_g.allFinite()) return "the mean must be finite";
  if (!sample.cov_g2.allFinite()) return "the covariance must be finite";
  if ((sample.cov_g2.diagonal().array() < 0).any()) return "variances must be at least 0";
  if (sample.temperature_c && !std::isfinite(*sample.temperature_c)) return "the temperature must be finite";
  return nullptr;
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
  if (size > UINT32_MAX) throw InvalidArgument("raw samples: too many for one pose");
  return static_cast<std::uint32_t>(size);
}

}  // namespace

Bytes encodeSamples(std::span<const GravitySample> samples) {
  Writer out(samples.size() * kSampleBytes);
  for (const GravitySample& sample : samples) {
    if (const char* problem = problemOf(sample)) {
      throw InvalidArgument("cell " + toString(sample.cell) + ": " + problem + " to be stored");
    }
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
    in.fail("samples: expected " + std::to_string(kSampleBytes) + " bytes for each cell, found " +
            std::to_string(bytes.size()) + " bytes");
  }
  std::vector<GravitySample> samples(bytes.size() / kSampleBytes);
  for (GravitySample& sample : samples) {
    sample.cell = CellId(in.get<std::uint32_t>());
    sample.count = in.get<std::uint32_t>();
    const auto flags = in.get<std::uint32_t>();
    if ((flags & ~kHasTemperature) != 0 || in.get<std::uint32_t>() != 0) {
      in.fail("samples: cell " + toString(sample.cell) + ": expected no other flags than 1 (has a temperature)");
    }
    for (double& value : sample.mean_g) value = in.get<double>();
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        sample.cov_g2(row, column) = sample.cov_g2(column, row) = in.get<double>();
      }
    }
    const auto temperature_c = in.get<double>();
    if (flags == kHasTemperature) sample.temperature_c = temperature_c;
    if (const char* problem = problemOf(sample)) {
      in.fail("samples: cell " + toString(sample.cell) + ": " + problem);
    }
  }
  return samples;
}

Bytes encodeFrames(std::span<const SampleFrame> frames) {
  bool is_short = true;
  forEachNumber(frames, [&](double value) {
    if (!std::isfinite(value)) throw InvalidArgument("raw samples: must be finite to be stored");
    is_short = is_short && isExactAsFloat(value);
  });
  std::size_t size = 8;
  for (const SampleFrame& frame : frames) {
    size += 20 + 28 * frame.samples.size() + 56 * frame.means.size() + 12 * frame.temperatures.size();
  }
  Writer out(size);
  const auto put = [&](double value) { is_short ? out.put(static_cast<float>(value)) : out.put(value); };
  out.put(is_short ? 4U : 8U);
  out.put(countOf(frames.size()));
  for (const SampleFrame& frame : frames) {
    if (!std::isfinite(frame.time_s)) throw InvalidArgument("raw samples: times must be finite to be stored");
    out.put(frame.time_s);
    out.put(countOf(frame.samples.size()));
    out.put(countOf(frame.means.size()));
    out.put(countOf(frame.temperatures.size()));
    for (const CellSample& sample : frame.samples) {
      out.put(sample.cell.value());
      for (const double value : sample.acceleration_g) put(value);
    }
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
  return out.take();
}

std::vector<SampleFrame> decodeFrames(std::span<const std::uint8_t> bytes, const std::string& where) {
  Reader in(bytes, where);
  const auto width = in.get<std::uint32_t>();
  if (width != 4 && width != 8) in.fail("raw samples: expected numbers of 4 or 8 bytes");
  const bool is_short = width == 4;
  constexpr std::size_t kFrameBytes = 20;
  std::vector<SampleFrame> frames(in.count(kFrameBytes));
  for (SampleFrame& frame : frames) {
    frame.time_s = in.finite(false);
    const auto samples = in.get<std::uint32_t>();
    const auto means = in.get<std::uint32_t>();
    const auto temperatures = in.get<std::uint32_t>();
    // Grown as they are read: the counts may be lies.
    for (std::uint32_t i = 0; i < samples; ++i) {
      const CellId cell(in.get<std::uint32_t>());
      frame.samples.push_back({cell, readVector(in, is_short)});
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
  if (!in.atEnd()) in.fail("raw samples: expected the end, found more data");
  return frames;
}

}  // namespace hexoderm
