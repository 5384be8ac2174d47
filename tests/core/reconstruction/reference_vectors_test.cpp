// An independent implementation's figures for the same files (README of the reference data): rms position in mm and rms
// orientation in degrees over all cells after alignment, paper's method.

#include "hexoderm/io/session_json.h"
#include "hexoderm/reconstruction/evaluation.h"
#include "hexoderm/reconstruction/reconstructor.h"
#include "hexoderm/util/units.h"
#include "support/matchers.h"

#include <algorithm>

namespace hexoderm {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

Session load(const std::string& name) {
  return readSessionJson(std::string(HEXODERM_REFERENCE_DATA) + "/vectors/" + name + ".session.json");
}

SolverOptions paper() {
  SolverOptions options;
  options.centring = Centring::Off;
  options.support_axes = SupportAxes::Off;
  return options;
}

struct Errors {
  double position_mm = 0;
  double orientation_deg = 0;
};

Errors errorsOf(const Session& session, const SolverOptions& options) {
  const auto result = reconstruct(*session.snapshot(), options);
  EXPECT_THAT(*result, IsFinite());
  const auto comparison = compareToTruth(*result, *session.truth());
  EXPECT_THAT(comparison, SizeIs(1));
  return {toMillimetres(comparison.front().position_rms_m), toDegrees(comparison.front().orientation_rms_rad)};
}

/// To 1 % or 0.005, whichever is more.
double tolerance(double expected) { return std::max(0.01 * expected, 0.005); }

struct Row {
  std::string name;
  double position_mm;
  double orientation_deg;
};

class ReferenceVectors : public ::testing::TestWithParam<Row> {};

TEST_P(ReferenceVectors, PapersMethodAgreesWithAnIndependentImplementation) {
  const Errors errors = errorsOf(load(GetParam().name), paper());
  EXPECT_NEAR(errors.position_mm, GetParam().position_mm, tolerance(GetParam().position_mm));
  EXPECT_NEAR(errors.orientation_deg, GetParam().orientation_deg, tolerance(GetParam().orientation_deg));
}

TEST_P(ReferenceVectors, DefaultsAreAtMostAsFarOff) {
  const Session session = load(GetParam().name);
  const Errors with_defaults = errorsOf(session, {});
  const Errors with_papers_method = errorsOf(session, paper());
  EXPECT_LE(with_defaults.position_mm, with_papers_method.position_mm + 1e-9);
  EXPECT_LE(with_defaults.orientation_deg, with_papers_method.orientation_deg + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Files, ReferenceVectors,
                         ::testing::Values(Row{"x17_cyl_p2", 2.600, 4.942}, Row{"x17_ideal_p3", 0.888, 0.000},
                                           Row{"ring8_p6", 1.872, 0.399}),
                         [](const auto& test) { return test.param.name; });

TEST(ReferenceVectorsWithLoops, OrientationOfPlane25Agrees) {
  const Session session = load("plane25_p3");
  const Errors errors = errorsOf(session, paper());
  EXPECT_NEAR(errors.orientation_deg, 3.68, 0.02 * 3.68);
  const Errors with_defaults = errorsOf(session, {});
  EXPECT_LE(with_defaults.orientation_deg, errors.orientation_deg);
  EXPECT_LE(with_defaults.position_mm, errors.position_mm);
}

TEST(ReferenceVectorsCylinder, X17AgreesInRadiusAndDistance) {
  const Session session = load("x17_cyl_p2");
  const auto result = reconstruct(*session.snapshot(), paper());
  EXPECT_EQ(result->patches.front().origin, CellId(1));
  const SurfaceEvaluation cylinder = evaluateSurface(result->patches.front(), SurfaceKind::Cylinder, 0.0501);
  EXPECT_NEAR(toMillimetres(*cylinder.delta_m), -0.295, 0.005);
  EXPECT_NEAR(toMillimetres(*cylinder.epsilon_m), 0.978, 0.0098);
}

TEST(ReferenceVectorsRing, OriginIsCell4) {
  const auto result = reconstruct(*load("ring8_p6").snapshot(), paper());
  EXPECT_EQ(result->patches.front().origin, CellId(4));
}

TEST(ReferenceVectorsDeadSensor, CellSevenIsNamedAndTheOthersAreStillGood) {
  const Session session = load("x17_dead_sensor_p6");
  const auto result = reconstruct(*session.snapshot());
  const auto stuck = std::ranges::find(result->findings, FindingCode::StuckSensor, &Finding::code);
  ASSERT_NE(stuck, result->findings.end());
  EXPECT_THAT(stuck->cells, ElementsAre(CellId(7)));
  EXPECT_EQ(result->find(CellId(7)).cell->placed_by, PlacedBy::Links);
  EXPECT_EQ(std::ranges::count(result->findings, FindingCode::LinkNotRigid, &Finding::code), 0);
  const auto comparison = compareToTruth(*result, *session.truth());
  ASSERT_THAT(comparison, SizeIs(1));
  for (const CellDifference& cell : comparison.front().cells) {
    if (cell.cell != CellId(7)) {
      EXPECT_LT(toDegrees(cell.orientation_rad), 2.5) << cell.cell;
    }
  }
}

}  // namespace
}  // namespace hexoderm
