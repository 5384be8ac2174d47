#include "hexoderm/util/finding.h"

#include "hexoderm/util/enum_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace hexoderm {
namespace {

using enum FindingCode;

/// Built at its first use, for a message is no constant expression.
const auto& table() {
  static const std::array the_table = {
      FindingDescription{DuplicateCell, "duplicate-cell", Severity::Error,
                         message("A cell ID is listed twice; the first entry counts.")},
      FindingDescription{ReservedCellId, "reserved-cell-id", Severity::Error,
                         message("A cell carries ID 0 or an interface's ID; it is left out.")},
      FindingDescription{UnknownPort, "unknown-port", Severity::Error,
                         message("A link names a port that the cell model does not have; it is left out.")},
      FindingDescription{UnknownCell, "unknown-cell", Severity::Error,
                         message("A link names a neighbour that is not in the list of cells; it is left out.")},
      FindingDescription{SelfLink, "self-link", Severity::Error,
                         message("A cell names itself as its neighbour; the link is left out.")},
      FindingDescription{OneSidedLink, "one-sided-link", Severity::Warning,
                         message("Only one of two cells reports the link; it is muted.")},
      FindingDescription{ContradictoryLink, "contradictory-link", Severity::Error,
                         message("The reports of two cells about a link disagree; the links concerned are muted.")},
      FindingDescription{DuplicateLink, "duplicate-link", Severity::Warning,
                         message("The same port is reported more than once, or two cells are joined twice.")},
      FindingDescription{ForbiddenPortPair, "forbidden-port-pair", Severity::Error,
                         message("A link joins two ports that the cell model forbids to join; it is muted.")},
      FindingDescription{InterfaceLink, "interface-link", Severity::Info,
                         message("A cell is connected to a computer interface; the edge is not part of the skin.")},
      FindingDescription{BodyPartBoundary, "body-part-boundary", Severity::Info,
                         message("A link joins cells of different body parts; it is muted, and the patch ends there.")},
      FindingDescription{
          ImplausibleBend, "implausible-bend", Severity::Warning,
          message("A link bends further than a skin link can; it is probably a cable or crosses a joint.")},
      FindingDescription{
          ImplausibleTwist, "implausible-twist", Severity::Warning,
          message("A link twists further than a skin link can; it is probably a cable or a wrong port.")},
      FindingDescription{
          ImplausibleYaw, "implausible-yaw", Severity::Warning,
          message(
              "A link is turned in the surface further than a skin link can be; probably a wrong port or a cable.")},
      FindingDescription{
          LinkNotRigid, "link-not-rigid", Severity::Warning,
          message("The two cells of a link moved against each other between poses; it is probably a joint.")},
      FindingDescription{
          LinkDoesNotClose, "link-does-not-close", Severity::Warning,
          message("With all other links the ends of this link come to lie far apart: it is probably a cable, or "
                  "another link of the loop is. Muted.")},
      FindingDescription{LinkSetAside, "link-set-aside", Severity::Info,
                         message("The operator set a link aside, as a cable for example; it is muted.")},
      FindingDescription{
          ContradictsModel, "contradicts-model", Severity::Error,
          message("All links of a patch twist one way, as on no surface: axes or ports are not as in the cell model.")},
      FindingDescription{NoSamples, "no-samples", Severity::Warning,
                         message("A cell has no usable reading in any enabled pose; it is placed through its links.")},
      FindingDescription{MissingSamples, "missing-samples", Severity::Info,
                         message("A cell has no reading in some enabled poses; it is placed from the others.")},
      FindingDescription{
          DeadSensor, "dead-sensor", Severity::Error,
          message("A cell's accelerometer reads nothing like gravity; the cell is placed through its links.")},
      FindingDescription{
          StuckSensor, "stuck-sensor", Severity::Error,
          message(
              "A cell's accelerometer does not change while the part moves; the cell is placed through its links.")},
      FindingDescription{SaturatedSensor, "saturated-sensor", Severity::Warning,
                         message("A reading lies at the end of the accelerometer's range; it is not used.")},
      FindingDescription{NoisySensor, "noisy-sensor", Severity::Warning,
                         message("A cell's readings scatter far more than its sensor's noise and the other cells'.")},
      FindingDescription{WrongNorm, "wrong-norm", Severity::Warning,
                         message("A cell's readings are further from 1 g than its sensor's offset and scale allow.")},
      FindingDescription{
          DeadAxis, "dead-axis", Severity::Error,
          message("One axis of a cell's accelerometer does not follow gravity; the cell is placed through its links.")},
      FindingDescription{
          WrongGain, "wrong-gain", Severity::Error,
          message("A cell's accelerometer reads too much or too little in every pose; it is placed by its links.")},
      FindingDescription{
          InconsistentSensor, "inconsistent-sensor", Severity::Error,
          message("A cell's readings fit no position of the cell in the patch; the cell is placed through its links.")},
      FindingDescription{IdenticalReadings, "identical-readings", Severity::Error,
                         message("Cells report the same readings, bit for bit; they are placed through their links.")},
      FindingDescription{
          SwappedReadings, "swapped-readings", Severity::Error,
          message("Two neighbours fit with each other's readings; they are placed through their links.")},
      FindingDescription{
          TurnedSensor, "turned-sensor", Severity::Error,
          message("A cell's readings are those of a cell that lies otherwise; it is placed through its links.")},
      FindingDescription{
          MovedCell, "moved-cell", Severity::Error,
          message("A cell turned against the others between two poses; it is placed through its links.")},
      FindingDescription{
          SuspiciousSensor, "suspicious-sensor", Severity::Warning,
          message("A cell's readings fit badly, and there are too few poses to say why; they are used.")},
      FindingDescription{
          SensorsUnlikeModel, "sensors-unlike-model", Severity::Warning,
          message("The errors of the accelerometers are together clearly larger than the cell model's sigmas.")},
      FindingDescription{LeftOut, "left-out", Severity::Info,
                         message("A cell was left out on request; it is placed through its links.")},
      FindingDescription{SampleOfUnknownCell, "sample-of-unknown-cell", Severity::Warning,
                         message("A pose holds a reading of a cell that is not in the skin; it is not used.")},
      FindingDescription{DuplicateSample, "duplicate-sample", Severity::Warning,
                         message("A pose holds two readings of one cell; the first counts.")},
      FindingDescription{DuplicatePose, "duplicate-pose", Severity::Warning, message("Two poses carry the same ID.")},
      FindingDescription{NoPoses, "no-poses", Severity::Warning,
                         message("There is no enabled pose: the placement follows from the ports alone.")},
      FindingDescription{TooFewDirections, "too-few-directions", Severity::Warning,
                         message("The poses show gravity along too few directions to fix every rotation.")},
      FindingDescription{RepeatedPose, "repeated-pose", Severity::Info,
                         message("Two poses show gravity along nearly the same line, which adds little.")},
      FindingDescription{
          PartMoved, "part-moved", Severity::Warning,
          message("Most cells scattered far beyond their noise in this pose: the part was probably moving.")},
      FindingDescription{
          InconsistentPose, "inconsistent-pose", Severity::Warning,
          message("The cells contradict each other in one pose far more than in the others; the part moved.")},
      FindingDescription{
          NotConverged, "not-converged", Severity::Warning,
          message("The joint estimate of a patch ended before its optimum; placements and stated uncertainties are "
                  "preliminary.")},
  };
  static_assert(the_table.size() == static_cast<std::size_t>(NotConverged) + 1);
  return the_table;
}

constexpr EnumNames<Severity, 3> kSeverities = {{"info", "warning", "error"}};

}  // namespace

std::span<const FindingDescription> findingTable() { return table(); }

std::string_view codeName(FindingCode code) { return table().at(static_cast<std::size_t>(code)).name; }

std::optional<FindingCode> codeFromName(std::string_view name) {
  const auto found = std::ranges::find(table(), name, &FindingDescription::name);
  return found == table().end() ? std::nullopt : std::optional(found->code);
}

std::string_view severityName(Severity severity) { return kSeverities.of(severity); }

std::optional<Severity> severityFromName(std::string_view name) { return kSeverities.find(name); }

Finding makeFinding(FindingCode code, Message message, std::vector<CellId> cells, std::vector<PortNumber> ports,
                    std::vector<PoseId> poses) {
  return {code,
          table().at(static_cast<std::size_t>(code)).severity,
          std::move(message),
          std::move(cells),
          std::move(ports),
          std::move(poses)};
}

void addOnce(std::vector<Finding>& findings, Finding finding) {
  const bool is_known = std::ranges::any_of(findings, [&](const Finding& known) {
    return known.code == finding.code && known.cells == finding.cells && known.ports == finding.ports &&
           known.poses == finding.poses;
  });
  if (!is_known) findings.push_back(std::move(finding));
}

}  // namespace hexoderm
