// Reading and writing sessions and calibrations: CPU time beside nlohmann's documents alone, and memory. All of a line
// is measured in one run, on the same text; the ratios are what counts.
//
//     documents_benchmark [CELLS...]     about so many cells each; 1260, 10000 and 100000 if none is said

#include <malloc.h>
#include <nlohmann/json.hpp>
#include "hexoderm/base/sha256.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/benchmarks/cpu_time.h"
#include "tests/support/options.h"
#include "tests/support/peak_memory.h"
#include "tests/support/simulated_skins.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace hexoderm {
namespace {

/// One kind of work on a text of so many bytes.
struct Work {
  const char* name;
  std::function<void()> run;
};

/// The works of a text, each with its speed relative to the last one.
void show(const char* title, std::size_t bytes, const std::vector<Work>& works) {
  const double megabytes = static_cast<double>(bytes) * 1e-6;
  std::printf("%s, %.1f MB\n", title, megabytes);
  std::vector<double> seconds;
  for (const Work& work : works)
    seconds.push_back(1e-3 * least_ms(work.run));  // with what it takes to free what was made
  ::malloc_trim(0);  // what the runs have freed would be there for the processes that are measured
  const double idle_MB = test::peakMemory_MB([] {});
  for (std::size_t k = 0; k < works.size(); ++k) {
    std::printf("  %-34s %9.1f ms %7.0f MB/s %6.2f x %8.0f MB\n", works[k].name, 1e3 * seconds[k],
                megabytes / seconds[k], seconds.back() / seconds[k], test::peakMemory_MB(works[k].run) - idle_MB);
  }
}

void measure(std::size_t cells) {
  const auto rows = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(cells))));
  const Session session = test::simulatedSession(test::bentSheet(rows, rows), 3);
  const auto calibration = reconstruct(*session.snapshot(), test::with(&SolverOptions::solver, Solver::Tree));
  std::printf("%zu cells, 3 poses\n", calibration->cellCount());

  const auto nowhere = [](std::string_view /*piece*/) {};
  const std::string session_text = sessionToJson(session);
  const std::string calibration_text = calibrationToJson(*calibration);
  const auto show_reading = [](const char* title, const std::string& json, const std::function<void()>& read) {
    std::size_t kept_size = 0;
    show(title, json.size(),
         {{"read", read},
          {"SHA-256 alone", [&] { sha256Hex(json); }},
          {"nlohmann, document alone", [&] { kept_size = nlohmann::json::parse(json).size(); }}});
  };
  show_reading("reading a session", session_text, [&] { parseSessionJson(session_text, "s.session.json"); });
  show_reading("reading a calibration", calibration_text, [&] { parseCalibrationJson(calibration_text, "c.json"); });
  const auto session_document = nlohmann::ordered_json::parse(session_text);
  show("writing a session", session_text.size(),
       {{"written", [&] { writeSessionJson(session, nowhere); }},
        {"nlohmann, of a document that is there", [&] { static_cast<void>(session_document.dump(1)); }}});
  const auto calibration_document = nlohmann::ordered_json::parse(calibration_text);
  show("writing a calibration", calibration_text.size(),
       {{"written", [&] { writeCalibrationJson(*calibration, nowhere); }},
        {"nlohmann, of a document that is there", [&] { static_cast<void>(calibration_document.dump(1)); }}});
}

}  // namespace
}  // namespace hexoderm

int main(int argc, char** argv) {
  std::vector<std::size_t> sizes;
  for (int k = 1; k < argc; ++k) sizes.push_back(std::stoul(argv[k]));
  if (sizes.empty()) sizes = {1260, 10'000, 100'000};
  for (const std::size_t cells : sizes) hexoderm::measure(cells);
  return 0;
}
