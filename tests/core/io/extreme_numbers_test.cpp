// Finite numbers that no skin has: what is not refused with its key path is solved, evaluated and written without a
// number that is none.

#include "hexoderm/base/limits.h"
#include "hexoderm/io/calibration_json.h"
#include "hexoderm/io/exporter.h"
#include "hexoderm/io/session_json.h"
#include "hexoderm/session/session_store.h"
#include "hexoderm/sim/simulated_session.h"
#include "hexoderm/skin/cell_model_json.h"
#include "hexoderm/solve/checks/evaluation.h"
#include "hexoderm/solve/metrics/pose_coverage.h"
#include "hexoderm/solve/reconstructor.h"
#include "tests/core/io/export_test_folder.h"
#include "tests/support/solvers.h"

#include <nlohmann/json.hpp>

namespace hexoderm {
namespace {

using Json = nlohmann::json;

constexpr std::array kExtremes = {0.0,   5e-324, 1e-300,  1e-100, 1e-12, 1e-9, 1e-6,  1e-3,   1.0,
                                  1e3,   1e6,    1e9,     1e12,   1e13,  1e30, 1e100, 1e154,  1e200,
                                  1e300, 1e308,  -1e-300, -1e-6,  -1e3,  -1e6, -1e12, -1e100, -1e308};

/// Six cells in a ring that is not closed, three poses, and a model that is written out.
Json sessionDocument() {
  SimulatedSkinOptions options;
  options.patch = "ring6";
  CellModel model = builtInCellModel("hex-bma150");
  model.name = "own";
  model.sensors.push_back({"thermometer", "temperature", {}});
  SimulatedSkin skin(model, options);
  Json document = Json::parse(sessionToJson(simulateSession(skin, 3)));
  document["poses"][0]["samples"][0]["temperature_c"] = 25.5;
  return document;
}

/// Pointers to the document's measuring numbers: no versions, counts and IDs.
std::vector<Json::json_pointer> measuresOf(const Json& document) {
  std::vector<Json::json_pointer> found;
  const Json flat = document.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    if (value.is_number_float()) found.emplace_back(pointer);
  }
  // These have whole numbers by chance.
  for (const char* key : {"side_angle_rad", "accelerometer/range_g", "accelerometer/rate_hz"}) {
    found.emplace_back(std::string("/cell_model/") + key);
  }
  return found;
}

/// All that is computed from a session.
void useEverything(const Session& session, const std::string& what) {
  SCOPED_TRACE(what);
  for (const Solver solver : {Solver::Global, Solver::Tree}) {
    const auto result = reconstruct(*session.snapshot(), test::by(solver));
    EXPECT_NO_THROW(static_cast<void>(calibrationToJson(*result))) << "it refuses every number that is none";
    for (const PatchReconstruction& patch : result->patches) {
      EXPECT_TRUE(adviseNextPose(session.model(), collect(patch.gravity, &GravityDirection::g_o), {}).up.allFinite());
      for (const SurfaceKind kind : {SurfaceKind::Plane, SurfaceKind::Sphere, SurfaceKind::Cylinder}) {
        try {
          const SurfaceEvaluation fit = evaluateSurface(patch, kind);
          EXPECT_TRUE(std::isfinite(fit.rms_m) && fit.point.allFinite() && fit.axis.allFinite());
          EXPECT_TRUE(!fit.radius_m || std::isfinite(*fit.radius_m));
        } catch (const InvalidArgument&) {
          // Too few cells in the patch, or no such surface through them: said in words.
        }
      }
    }
    if (session.truth()) {
      for (const Comparison& comparison : compareToTruth(*result, *session.truth())) {
        EXPECT_TRUE(std::isfinite(comparison.position_rms_m) && std::isfinite(comparison.orientation_rms_rad));
      }
    }
  }
}

/// Refused with the key, or used. Returns whether it was accepted.
bool tryDocument(const Json& document, const std::string& what, const std::string& key = "") {
  std::optional<Session> session;
  try {
    session = parseSessionJson(document.dump(), "extreme.session.json");
  } catch (const FormatError& error) {
    EXPECT_THAT(error.what(), HasSubstr("extreme.session.json: ")) << what;
    EXPECT_THAT(error.what(), HasSubstr(key)) << what;
    return false;
  }
  useEverything(*session, what);
  return true;
}

/// The last part of a pointer that is a name.
std::string keyOf(Json::json_pointer pointer) {
  while (!pointer.empty() && pointer.back().find_first_not_of("0123456789") == std::string::npos) pointer.pop_back();
  return pointer.empty() ? "" : pointer.back();
}

TEST(ExtremeNumbers, EachIsRefusedByItsKeyOrUsed) {
  const Json document = sessionDocument();
  ASSERT_TRUE(tryDocument(document, "as it is"));
  std::size_t accepted = 0;
  std::size_t refused = 0;
  std::set<std::string> seen;
  for (const Json::json_pointer& pointer : measuresOf(document)) {
    // One cell of a pose and one pose stand for all.
    const std::string text = pointer.to_string();
    std::string kind = text;
    for (char& c : kind) {
      if (c >= '0' && c <= '9') c = '#';
    }
    if (text.starts_with("/poses") && !seen.insert(kind + text.back()).second) continue;
    if (text.starts_with("/truth") && !seen.insert(kind + text.back()).second) continue;
    for (const double value : kExtremes) {
      Json changed = document;
      changed[pointer] = value;
      const std::string what = text + " = " + Json(value).dump();
      (tryDocument(changed, what, keyOf(pointer)) ? accepted : refused) += 1;
    }
  }
  EXPECT_GT(accepted, 200U);
  EXPECT_GT(refused, 200U);
}

TEST(ExtremeNumbers, SeveralAtOnceAreUsed) {
  const Json document = sessionDocument();
  const std::vector<Json::json_pointer> measures = measuresOf(document);
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  std::size_t accepted = 0;
  for (int k = 0; k < 400; ++k) {
    Json changed = document;
    std::string what;
    for (std::size_t n = 1 + below(5); n > 0; --n) {
      const Json::json_pointer& pointer = measures[below(measures.size())];
      const double value = kExtremes.at(below(kExtremes.size()));
      changed[pointer] = value;
      what += pointer.to_string() + " = " + Json(value).dump() + "; ";
    }
    if (tryDocument(changed, what)) ++accepted;
  }
  EXPECT_GT(accepted, 30U);
}

/// The largest of everything that is accepted, in every cell.
TEST(ExtremeNumbers, TheLargestReadingsAreUsed) {
  for (const double reading_g : {kMaxAcceleration_g, 1e-6 * kMaxAcceleration_g, 1e-300}) {
    for (const double variance_g2 : {0.0, 5e-324, 1e-12, kMaxVariance_g2}) {
      Json document = sessionDocument();
      double sign = 1;
      for (Json& pose : document["poses"]) {
        for (Json& sample : pose["samples"]) {
          sample["mean_g"] = {sign * reading_g, reading_g, -sign * reading_g};
          sample["cov_g2"] = {variance_g2, -variance_g2, variance_g2, variance_g2, -variance_g2, variance_g2};
          sample["count"] = sign > 0 ? 1U : UINT32_MAX;
          sign = -sign;
        }
      }
      EXPECT_TRUE(tryDocument(document, Json(reading_g).dump() + " g, " + Json(variance_g2).dump() + " g^2"));
    }
  }
}

class ExtremeExports : public ExportTest {};

TEST_F(ExtremeExports, AllFormatsHoldThem) {
  Json document = sessionDocument();
  document["poses"][0]["samples"][1]["mean_g"] = {kMaxAcceleration_g, -kMaxAcceleration_g, 0};
  for (Json& port : document["cell_model"]["ports"]) {
    port["vector_m"] = {port["vector_m"][0].get<double>() * 50, port["vector_m"][1].get<double>() * 50, 0};
  }
  const Session session = parseSessionJson(document.dump(), "large.session.json");
  const auto result = reconstruct(*session.snapshot());
  ExportOptions options;
  options.robot_urdf = temporary_.put("robot.urdf", "<robot name=\"arm\"><link name=\"base_link\"/></robot>");
  for (const ExportFormatDescription& format : exportFormats()) {
    EXPECT_NO_THROW(exportReconstruction(*result, format.format, in("large" + std::string(format.extension)), options))
        << format.name;
  }
}

TEST_F(ExtremeExports, AStoreRefusesWhatAFileDoes) {
  const Session session = parseSessionJson(sessionDocument().dump(), "a.session.json");
  SessionStore store = SessionStore::create(in("a.hexo"), session);
  const auto poseOf = [&](double reading_g, double variance_g2) {
    PoseCapture capture = *session.poses()[0].capture;
    capture.samples[0].mean_g.x() = reading_g;
    capture.samples[0].cov_g2(1, 1) = variance_g2;
    return std::vector<StoreOperation>{AddPose{{std::make_shared<const PoseCapture>(std::move(capture))}}};
  };
  EXPECT_NO_THROW(store.append(poseOf(-kMaxAcceleration_g, kMaxVariance_g2)));
  EXPECT_THROW(store.append(poseOf(1e7, 1)), InvalidArgument);
  EXPECT_THROW(store.append(poseOf(-1e308, 1)), InvalidArgument);
  EXPECT_THROW(store.append(poseOf(1, 1e14)), InvalidArgument);
  useEverything(store.readSession(), "from the store");
}

}  // namespace
}  // namespace hexoderm
