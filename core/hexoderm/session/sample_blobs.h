#pragma once

// Readings as bytes, little-endian; the layouts are documented in README.md beside this file.

#include "hexoderm/device/pose_capture.h"
#include "hexoderm/device/sample_frame.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hexoderm {

using Bytes = std::vector<std::uint8_t>;

/// Throws InvalidArgument naming the cell for what can't be stored: numbers that are not finite, negative variances.
Bytes encodeSamples(std::span<const GravitySample> samples);
/// Throws FormatError; `where` begins its message.
std::vector<GravitySample> decodeSamples(std::span<const std::uint8_t> bytes, const std::string& where);

/// Encodes the raw samples of one pose. If all readings are whole multiples of `lsb_g`, as a device's are, numbers take
/// a byte or two each; if all are exact as single-precision numbers, 4 bytes, else 8. `lsb_g` 0: no step is known.
/// Throws InvalidArgument for numbers that are not finite.
Bytes encodeFrames(std::span<const SampleFrame> frames, double lsb_g = 0);
/// As many as that makes at most.
std::size_t mostBytesOf(std::span<const SampleFrame> frames);
std::vector<SampleFrame> decodeFrames(std::span<const std::uint8_t> bytes, const std::string& where);

}  // namespace hexoderm
