// Any text as a TUM SkinConfig: a sound configuration, session and calibration, or an Error.

#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/tum_xml.h"

#include "tests/fuzz/fuzz_checks.h"

#include <memory>

using namespace hexoderm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const CellModel model = builtInCellModel("hex-bma150");
  std::shared_ptr<const Reconstruction> calibration;
  fuzz::takeOrComplain([&] {
    const TumSkinConfig config = parseTumXml(fuzz::asText({data, size}), "fuzz.xml");
    fuzz::requireSound(sessionFromTum(config, model, "fuzz.xml"));
    calibration = calibrationFromTum(config, model, "fuzz.xml");
  });
  // The writer refuses every number that is none.
  if (calibration) calibrationToJson(*calibration);
  return 0;
}
