// Any text as a TUM SkinConfig: a sound configuration, session and calibration, or an Error.

#include "hexoderm/io/tum_xml.h"

#include "tests/fuzz/fuzz_checks.h"

#include <cmath>
#include <optional>

namespace {

using namespace hexoderm;

void requireFinite(const Reconstruction& calibration) {
  for (const PatchReconstruction& patch : calibration.patches) {
    for (const CellPlacement& cell : patch.cells) {
      fuzz::require(cell.T_o_u.t.allFinite() && cell.T_o_u.R.allFinite(), "finite placements");
      for (const SensorPlacement& sensor : cell.sensors) {
        fuzz::require(sensor.T_o_s.t.allFinite() && sensor.T_o_s.R.allFinite(), "finite sensors");
      }
    }
    for (const LinkEstimate& link : patch.links) {
      fuzz::require(link.R_c_n.allFinite(), "finite rotations of links");
      fuzz::require(std::isfinite(link.bend_rad) && std::isfinite(link.twist_rad) && std::isfinite(link.yaw_rad),
                    "finite angles of links");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const CellModel model = builtInCellModel("hex-bma150");
  fuzz::takeOrComplain([&] {
    const TumSkinConfig config = parseTumXml(fuzz::asText({data, size}), "fuzz.xml");
    fuzz::requireSound(sessionFromTum(config, model, "fuzz.xml"));
    requireFinite(*calibrationFromTum(config, model, "fuzz.xml"));
  });
  return 0;
}
