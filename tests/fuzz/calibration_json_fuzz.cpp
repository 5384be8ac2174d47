// Any text as a *.calibration.json: a calibration of finite numbers, which can be written, read again and exported, or
// an Error.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/exporter.h"

#include "tests/fuzz/fuzz_checks.h"

#include <memory>

namespace {

using namespace hexoderm;

constexpr const char* kFile = "fuzz.calibration.json";

std::shared_ptr<const Reconstruction> parsed(std::string_view text) {
  std::shared_ptr<const Reconstruction> calibration;
  fuzz::takeOrComplain([&] { calibration = parseCalibrationJson(text, kFile); });
  return calibration;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::shared_ptr<const Reconstruction> calibration = parsed(fuzz::asText({data, size}));
  if (!calibration) return 0;
  // The writer refuses every number that is none.
  fuzz::require(parsed(calibrationToJson(*calibration)) != nullptr, "what was written to be read again");
  fuzz::takeOrComplain([&] { fuzz::require(!exportBytes(*calibration, ExportFormat::Urdf, {}).empty(), "a URDF"); });
  return 0;
}
