#include "hexoderm/util/finding.h"

#include "hexoderm/util/enum_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace hexoderm {
namespace {

using enum FindingCode;

FindingDescription entry(FindingCode code, std::string_view name, Severity severity, Message meaning, Message why,
                         Message what_to_do, std::vector<FindingRemedy> remedies) {
  return {code, name, severity, std::move(meaning), std::move(why), std::move(what_to_do), std::move(remedies)};
}

/// Built at its first use, for a message is no constant expression.
const auto& table() {
  using enum FindingRemedy;
  static const std::array the_table = {
      entry(DuplicateCell, "duplicate-cell", Severity::Error,
            message("A cell ID is listed twice; the first entry counts."),
            message("The device's list names one ID twice, and two cells can't share an ID."),
            message("Give one of the two cells another ID, and connect again."), {LightCell}),
      entry(ReservedCellId, "reserved-cell-id", Severity::Error,
            message("A cell carries ID 0 or an interface's ID; it is left out."),
            message("ID 0 stands for nothing, and the interface's ID for the computer: a cell with such an ID "
                    "can't be told from them."),
            message("Give the cell another ID, and connect again."), {}),
      entry(UnknownPort, "unknown-port", Severity::Error,
            message("A link names a port that the cell model does not have; it is left out."),
            message("The port that was reported is not among those of the cell model."),
            message("Check that the cell model is that of this skin. If it is, the report of the cell is "
                    "wrong: connect again."),
            {LightCell}),
      entry(UnknownCell, "unknown-cell", Severity::Error,
            message("A link names a neighbour that is not in the list of cells; it is left out."),
            message("A cell reports a neighbour that did not report itself: it has no power, or its report was lost."),
            message("Check the power and the contacts of the missing cell, and connect again."), {LightCell}),
      entry(SelfLink, "self-link", Severity::Error,
            message("A cell names itself as its neighbour; the link is left out."),
            message(
                "A link joins two cells. One that ends where it begins comes from a short circuit or a wrong report."),
            message("Check the ports of this cell, and connect again."), {LightCell}),
      entry(OneSidedLink, "one-sided-link", Severity::Warning,
            message("Only one of two cells reports the link; it is muted."),
            message("A sound link is seen from both of its ends, and here one end sees nothing: a contact is "
                    "loose, or a report was lost."),
            message("Check the contacts between the two cells, and connect again. If nothing joins them there, "
                    "leave it as it is."),
            {LightCell}),
      entry(ContradictoryLink, "contradictory-link", Severity::Error,
            message("The reports of two cells about a link disagree; the links concerned are muted."),
            message("The two cells name different ports, or different neighbours, for what should be one link."),
            message("Check how the two cells are joined, and connect again."), {LightCell}),
      entry(DuplicateLink, "duplicate-link", Severity::Warning,
            message("The same port is reported more than once, or two cells are joined twice."),
            message("A port leads to one neighbour at most, and two cells are joined once at most."),
            message("Check the ports that are named for a short circuit or a wrong cable, and connect again."),
            {LightCell}),
      entry(ForbiddenPortPair, "forbidden-port-pair", Severity::Error,
            message("A link joins two ports that the cell model forbids to join; it is muted."),
            message("Cells side by side in the mould can't touch with these two ports."),
            message("If a cable joins the two cells, leave it as it is. If not, check the cell model."), {LightCell}),
      entry(InterfaceLink, "interface-link", Severity::Info,
            message("A cell is connected to a computer interface; the edge is not part of the skin."),
            message("The computer's interface is at this port, and it is no cell."),
            message("Nothing: this is as it should be."), {}),
      entry(BodyPartBoundary, "body-part-boundary", Severity::Info,
            message("A link joins cells of different body parts; it is muted, and the patch ends there."),
            message("Body parts move against each other, so a link between them is not rigid."),
            message("Nothing, if the names of the body parts are right."), {}),
      entry(
          ImplausibleBend, "implausible-bend", Severity::Warning,
          message("A link bends further than a skin link can; it is probably a cable or crosses a joint."),
          message(
              "Gravity, as the two cells feel it, says that they stand at a steeper angle than the mould lets them."),
          message("Look at the two cells. If a cable joins them, or a joint lies between them, set the link aside. If "
                  "they lie side by side in the mould, check the axes of their sensors."),
          {MuteLink, LightCell}),
      entry(ImplausibleTwist, "implausible-twist", Severity::Warning,
            message("A link twists further than a skin link can; it is probably a cable or a wrong port."),
            message("Gravity, as the two cells feel it, says that they are twisted about the line between them "
                    "further than the mould lets them."),
            message("Look at the two cells. If a cable joins them, or other ports than those that are named, "
                    "set the link aside. If not, check the axes of their sensors."),
            {MuteLink, LightCell}),
      entry(
          ImplausibleYaw, "implausible-yaw", Severity::Warning,
          message("A link is turned in the surface further than a skin link can be; probably a wrong port or a cable."),
          message("Gravity, as the two cells feel it, says that they are turned against each other in the "
                  "surface further than the mould lets them."),
          message("Look at the two cells. If a cable joins them, or other ports than those that are named, "
                  "set the link aside. If not, check the axes of their sensors."),
          {MuteLink, LightCell}),
      entry(LinkNotRigid, "link-not-rigid", Severity::Warning,
            message("The two cells of a link moved against each other between poses; it is probably a joint."),
            message(
                "The angle between the two cells was another one from pose to pose, by more than their readings err."),
            message("If a joint lies between the two cells, set the link aside. If not, fix them in the mould and take "
                    "the poses again."),
            {MuteLink, LightCell}),
      entry(LinkDoesNotClose, "link-does-not-close", Severity::Warning,
            message("With all other links the ends of this link come to lie far apart: it is probably a cable, or "
                    "another link of the loop is. Muted."),
            message("Where all other links are followed, the two ends of this one should meet, and they do not."),
            message(
                "Look at the links of this loop for a cable. Set that one aside; if this one is sound, take it back."),
            {MuteLink, LightCell}),
      entry(LinkSetAside, "link-set-aside", Severity::Info,
            message("The operator set a link aside, as a cable for example; it is muted."),
            message("Somebody set this link aside in this session."),
            message("Nothing. Take the link back if it should count again."), {MuteLink}),
      entry(
          ContradictsModel, "contradicts-model", Severity::Error,
          message("All links of a patch twist one way, as on no surface: axes or ports are not as in the cell model."),
          message("A surface bends to either side. A twist to one side everywhere comes from a wrong "
                  "description of the cell."),
          message("Compare the axes and the numbers of the ports in the cell model with a real cell."), {}),
      entry(NoSamples, "no-samples", Severity::Warning,
            message("A cell has no usable reading in any enabled pose; it is placed through its links."),
            message("The cell sent no readings that can be used in any pose that counts."),
            message("Check the power and the contacts of the cell, and take the poses again. It may stay as it "
                    "is: it is less certain than the others then."),
            {LightCell, TakePose}),
      entry(MissingSamples, "missing-samples", Severity::Info,
            message("A cell has no reading in some enabled poses; it is placed from the others."),
            message("The cell sent no readings that can be used while these poses were captured."),
            message("Nothing has to be done. With these poses taken again the cell is known better."),
            {RecapturePose, LightCell}),
      entry(DeadSensor, "dead-sensor", Severity::Error,
            message("A cell's accelerometer reads nothing like gravity; the cell is placed through its links."),
            message("At rest a sensor reads 1 g along some direction, and this one reads nothing like it."),
            message("Replace the cell, or leave it as it is: it is less certain than the others then."), {LightCell}),
      entry(
          StuckSensor, "stuck-sensor", Severity::Error,
          message("A cell's accelerometer does not change while the part moves; the cell is placed through its links."),
          message("The part was turned from pose to pose, and what this sensor reads stayed the same."),
          message("Replace the cell, or leave it as it is: it is less certain than the others then."), {LightCell}),
      entry(SaturatedSensor, "saturated-sensor", Severity::Warning,
            message("A reading lies at the end of the accelerometer's range; it is not used."),
            message("At the end of its range a sensor can't tell how large a value is."),
            message(
                "Take the pose again without a jolt. If it happens again, check the range that the sensor is set to."),
            {RecapturePose, LightCell}),
      entry(NoisySensor, "noisy-sensor", Severity::Warning,
            message("A cell's readings scatter far more than its sensor's noise and the other cells'."),
            message("The part was still, as the other cells show, and the readings of this one scatter."),
            message("Check that the cell sits firmly and that its power is steady, and take the poses again."),
            {RecapturePose, LightCell}),
      entry(WrongNorm, "wrong-norm", Severity::Warning,
            message("A cell's readings are further from 1 g than its sensor's offset and scale allow."),
            message("At rest a reading is 1 g long, whatever its direction."),
            message("Take the pose again and hold the part stiller: its motion adds to gravity, most of all far from "
                    "where it is held. If it happens again, check the sensor of the cell, and the scale in which "
                    "its readings are sent."),
            {RecapturePose, LightCell}),
      entry(
          DeadAxis, "dead-axis", Severity::Error,
          message("One axis of a cell's accelerometer does not follow gravity; the cell is placed through its links."),
          message("From pose to pose two axes follow gravity, and the third does not."),
          message("Replace the cell, or leave it as it is: it is less certain than the others then."), {LightCell}),
      entry(
          WrongGain, "wrong-gain", Severity::Error,
          message("A cell's accelerometer reads too much or too little in every pose; it is placed by its links."),
          message(
              "At rest a reading is 1 g long, and the readings of this cell are too long or too short in every pose."),
          message("Check the sensor of the cell, and the scale in which its readings are sent."), {LightCell}),
      entry(
          InconsistentSensor, "inconsistent-sensor", Severity::Error,
          message("A cell's readings fit no position of the cell in the patch; the cell is placed through its links."),
          message("However the cell is placed in the patch, its readings contradict those of the others."),
          message("Check that the cell is not loose, and that its axes are those of the cell model."), {LightCell}),
      entry(IdenticalReadings, "identical-readings", Severity::Error,
            message("Cells report the same readings, bit for bit; they are placed through their links."),
            message("No two sensors read the same to the last bit: the readings of one cell were sent in the "
                    "name of another."),
            message("Check the IDs of these cells, and how their data are passed on."), {LightCell}),
      entry(SwappedReadings, "swapped-readings", Severity::Error,
            message("Two neighbours fit with each other's readings; they are placed through their links."),
            message("If the readings of the two cells are exchanged, they fit with those around them."),
            message("Exchange the IDs of the two cells, or check how their data are passed on."), {LightCell}),
      entry(TurnedSensor, "turned-sensor", Severity::Error,
            message("A cell's readings are those of a cell that lies otherwise; it is placed through its links."),
            message("The readings fit as soon as the cell is taken to lie otherwise."),
            message("Look how the cell lies in the mould, and whether its sensor sits as the cell model says."),
            {LightCell}),
      entry(MovedCell, "moved-cell", Severity::Error,
            message("A cell turned against the others between two poses; it is placed through its links."),
            message("From one pose on the readings fit another orientation of the cell than before."),
            message("Fix the cell in the mould, and take the poses again."), {LightCell, TakePose}),
      entry(SuspiciousSensor, "suspicious-sensor", Severity::Warning,
            message("A cell's readings fit badly, and there are too few poses to say why; they are used."),
            message("The readings fit worse than those of the other cells, and several causes would explain it."),
            message("Take another pose: it tells more about the cause."), {TakePose, LightCell}),
      entry(
          SensorsUnlikeModel, "sensors-unlike-model", Severity::Warning,
          message("The errors of the accelerometers are together clearly larger than the cell model's sigmas."),
          message(
              "Freed from all that is known, the readings still differ by more than the cell model's sigmas explain."),
          message("Find out the errors with hexoderm-cli sensors, and write them into the cell model."), {}),
      entry(LeftOut, "left-out", Severity::Info,
            message("A cell was left out on request; it is placed through its links."),
            message("It was asked for when this result was solved."),
            message("Nothing. Solve again with the cell if it should count."), {LightCell}),
      entry(SampleOfUnknownCell, "sample-of-unknown-cell", Severity::Warning,
            message("A pose holds a reading of a cell that is not in the skin; it is not used."),
            message("The pose was captured with other cells than the skin has, or an ID was misread."),
            message("Connect again, so that the list of cells is read anew, and take the pose again."),
            {RecapturePose, DisablePose}),
      entry(DuplicateSample, "duplicate-sample", Severity::Warning,
            message("A pose holds two readings of one cell; the first counts."),
            message("A cell has one reading in a pose, and nothing says which of the two is right."),
            message("Take the pose again if the cell does not fit."), {RecapturePose, LightCell}),
      entry(DuplicatePose, "duplicate-pose", Severity::Warning, message("Two poses carry the same ID."),
            message("Every pose has an ID of its own; files that were joined can hold one twice."),
            message("Disable one of the two if they are the same."), {DisablePose}),
      entry(NoPoses, "no-poses", Severity::Warning,
            message("There is no enabled pose: the placement follows from the ports alone."),
            message(
                "The ports say how cells lie beside each other in a plane. Only gravity tells how the surface bends."),
            message("Hold the part still, and take a first pose."), {TakePose}),
      entry(TooFewDirections, "too-few-directions", Severity::Warning,
            message("The poses show gravity along too few directions to fix every rotation."),
            message("About a line along which gravity was always seen, a cell could be turned in any way."),
            message("Turn the part by about 90 degrees about a horizontal axis, and take a pose."), {TakePose}),
      entry(RepeatedPose, "repeated-pose", Severity::Info,
            message("Two poses show gravity along nearly the same line, which adds little."),
            message("Gravity along a line that was seen before tells nothing new about the shape."),
            message("Nothing has to be done. Turn the part further before the next pose."), {TakePose}),
      entry(PartMoved, "part-moved", Severity::Warning,
            message("Most cells scattered far beyond their noise in this pose: the part was probably moving."),
            message("While a part moves, its sensors feel the motion beside gravity."),
            message("Take the pose again and hold the part still, or disable it."), {RecapturePose, DisablePose}),
      entry(
          InconsistentPose, "inconsistent-pose", Severity::Warning,
          message("The cells contradict each other in one pose far more than in the others; the part moved."),
          message("In the other poses the cells agree: in this one the part moved, or something pressed on the skin."),
          message("Take the pose again and let nothing touch the skin, or disable it."), {RecapturePose, DisablePose}),
      entry(NotConverged, "not-converged", Severity::Warning,
            message("The joint estimate of a patch ended before its optimum; placements and stated uncertainties are "
                    "preliminary."),
            message("The estimate goes on in steps as long as they make the shape more probable, and the steps "
                    "ran out."),
            message("Take another pose: two alone often leave open where the optimum is. Until then rely on no "
                    "figure of this patch."),
            {TakePose}),
  };
  static_assert(the_table.size() == static_cast<std::size_t>(NotConverged) + 1);
  return the_table;
}

constexpr EnumNames<Severity> kSeverities = {{"info", "warning", "error"}};

}  // namespace

std::span<const FindingDescription> findingTable() { return table(); }

const FindingDescription& descriptionOf(FindingCode code) { return table().at(static_cast<std::size_t>(code)); }

std::string_view codeName(FindingCode code) { return descriptionOf(code).name; }

std::optional<FindingCode> codeFromName(std::string_view name) {
  const auto found = std::ranges::find(table(), name, &FindingDescription::name);
  return found == table().end() ? std::nullopt : std::optional(found->code);
}

std::string_view severityName(Severity severity) { return kSeverities.of(severity); }

std::optional<Severity> severityFromName(std::string_view name) { return kSeverities.find(name); }

Finding makeFinding(FindingCode code, Message message, std::vector<CellId> cells, std::vector<PortNumber> ports,
                    std::vector<PoseId> poses) {
  return {code, descriptionOf(code).severity, std::move(message), std::move(cells), std::move(ports), std::move(poses)};
}

void addOnce(std::vector<Finding>& findings, Finding finding) {
  const bool is_known = std::ranges::any_of(findings, [&](const Finding& known) {
    return known.code == finding.code && known.cells == finding.cells && known.ports == finding.ports &&
           known.poses == finding.poses;
  });
  if (!is_known) findings.push_back(std::move(finding));
}

}  // namespace hexoderm
