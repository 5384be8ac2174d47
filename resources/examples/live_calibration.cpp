// A live calibration: takes poses from a skin, solves them as they come, and writes the result for robots.
// Usage: live_calibration SOURCE [auto]   a skin such as tcp://HOST:PORT or serial:/dev/ttyACM0, which is turned by
//                                         hand, or turns itself
#include <hexoderm/hexoderm.h>

#include <iostream>

int main(int argc, char** argv) try {
  hexoderm::LiveCaptureOptions options;
  options.source = argc > 1 ? argv[1] : "";
  options.automatic = argc > 2;
  options.poses = 4;
  hexoderm::LiveCapture capture(options);
  while (const auto pose = capture.next()) {
    const auto state = capture.state();
    std::cout << "Pose " << pose->pose->id << ": " << state.result->assessment.reason << '\n'
              << state.result->assessment.next_action << '\n';
  }
  const auto result = capture.state().result;
  hexoderm::writeCalibrationJson(*result, "live.calibration.json");
  hexoderm::exportReconstruction(*result, hexoderm::ExportFormat::Urdf, "live.urdf");
} catch (const hexoderm::Error& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
