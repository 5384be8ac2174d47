// A live calibration: takes poses from a skin, solves them as they come, and writes the result for robots.
// Usage: live_calibration [SOURCE]   a skin such as tcp://HOST:PORT or serial:/dev/ttyACM0, which is turned by hand;
//                                    without it a simulated one, which turns itself
#include <hexoderm/hexoderm.h>

#include <iostream>

int main(int argc, char** argv) try {
  hexoderm::LiveCaptureOptions options;
  options.source = argc > 1 ? argv[1] : "sim:x17?speed=max";
  options.automatic = argc == 1;
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
