#include "hexoderm/base/finding.h"

#include "hexoderm/base/enum_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace hexoderm {
namespace {

using enum FindingCode;

/// Built at its first use, for a message is no constant expression.
const auto& table() {
  using enum FindingRemedy;
  static const auto the_table = std::to_array<FindingDescription>({
      {.code = DuplicateCell,
       .name = "duplicate-cell",
       .severity = Severity::Error,
       .meaning = message("A cell ID is listed twice; the first entry counts."),
       .why = message("The device's list names one ID twice, and two cells can't share an ID."),
       .what_to_do = message("Give one of the two cells another ID, and connect again."),
       .remedies = {LightCell}},
      {.code = ReservedCellId,
       .name = "reserved-cell-id",
       .severity = Severity::Error,
       .meaning = message("A cell carries ID 0 or an interface's ID; it is left out."),
       .why = message("ID 0 stands for nothing, and the interface's ID for the computer: a cell with such an ID "
                      "can't be told from them."),
       .what_to_do = message("Give the cell another ID, and connect again."),
       .remedies = {}},
      {.code = UnknownPort,
       .name = "unknown-port",
       .severity = Severity::Error,
       .meaning = message("A link names a port that the cell model does not have; it is left out."),
       .why = message("The port that was reported is not among those of the cell model."),
       .what_to_do = message("Check that the cell model is that of this skin. If it is, the report of the cell is "
                             "wrong: connect again."),
       .remedies = {LightCell}},
      {.code = UnknownCell,
       .name = "unknown-cell",
       .severity = Severity::Error,
       .meaning = message("A link names a neighbour that is not in the list of cells; it is left out."),
       .why =
           message("A cell reports a neighbour that did not report itself: it has no power, or its report was lost."),
       .what_to_do = message("Check the power and the contacts of the missing cell, and connect again."),
       .remedies = {LightCell}},
      {.code = SelfLink,
       .name = "self-link",
       .severity = Severity::Error,
       .meaning = message("A cell names itself as its neighbour; the link is left out."),
       .why = message(
           "A link joins two cells. One that ends where it begins comes from a short circuit or a wrong report."),
       .what_to_do = message("Check the ports of this cell, and connect again."),
       .remedies = {LightCell}},
      {.code = OneSidedLink,
       .name = "one-sided-link",
       .severity = Severity::Warning,
       .meaning = message("Only one of two cells reports the link; it is muted."),
       .why = message("A sound link is seen from both of its ends, and here one end sees nothing: a contact is "
                      "loose, or a report was lost."),
       .what_to_do =
           message("Check the contacts between the two cells, and connect again. If nothing joins them there, "
                   "leave it as it is."),
       .remedies = {LightCell}},
      {.code = ContradictoryLink,
       .name = "contradictory-link",
       .severity = Severity::Error,
       .meaning = message("The reports of two cells about a link disagree; the links concerned are muted."),
       .why = message("The two cells name different ports, or different neighbours, for what should be one link."),
       .what_to_do = message("Check how the two cells are joined, and connect again."),
       .remedies = {LightCell}},
      {.code = DuplicateLink,
       .name = "duplicate-link",
       .severity = Severity::Warning,
       .meaning = message("The same port is reported more than once, or two cells are joined twice."),
       .why = message("A port leads to one neighbour at most, and two cells are joined once at most."),
       .what_to_do = message("Check the ports that are named for a short circuit or a wrong cable, and connect again."),
       .remedies = {LightCell}},
      {.code = ForbiddenPortPair,
       .name = "forbidden-port-pair",
       .severity = Severity::Error,
       .meaning = message("A link joins two ports that the cell model forbids to join; it is muted."),
       .why = message("Cells side by side in the mould can't touch with these two ports."),
       .what_to_do = message("If a cable joins the two cells, leave it as it is. If not, check the cell model."),
       .remedies = {LightCell}},
      {.code = InterfaceLink,
       .name = "interface-link",
       .severity = Severity::Info,
       .meaning = message("A cell is connected to a computer interface; the edge is not part of the skin."),
       .why = message("The computer's interface is at this port, and it is no cell."),
       .what_to_do = message("Nothing: this is as it should be."),
       .remedies = {}},
      {.code = BodyPartBoundary,
       .name = "body-part-boundary",
       .severity = Severity::Info,
       .meaning = message("A link joins cells of different body parts; it is muted, and the patch ends there."),
       .why = message("Body parts move against each other, so a link between them is not rigid."),
       .what_to_do = message("Nothing, if the names of the body parts are right."),
       .remedies = {}},
      {.code = ImplausibleBend,
       .name = "implausible-bend",
       .severity = Severity::Warning,
       .meaning = message("A link bends further than a skin link can; it is probably a cable or crosses a joint."),
       .why = message(
           "Gravity, as the two cells feel it, says that they stand at a steeper angle than the mould lets them."),
       .what_to_do =
           message("Look at the two cells. If a cable joins them, or a joint lies between them, set the link aside. If "
                   "they lie side by side in the mould, check the axes of their sensors."),
       .remedies = {MuteLink, LightCell}},
      {.code = ImplausibleTwist,
       .name = "implausible-twist",
       .severity = Severity::Warning,
       .meaning = message("A link twists further than a skin link can; it is probably a cable or a wrong port."),
       .why = message("Gravity, as the two cells feel it, says that they are twisted about the line between them "
                      "further than the mould lets them."),
       .what_to_do = message("Look at the two cells. If a cable joins them, or other ports than those that are named, "
                             "set the link aside. If not, check the axes of their sensors."),
       .remedies = {MuteLink, LightCell}},
      {.code = ImplausibleYaw,
       .name = "implausible-yaw",
       .severity = Severity::Warning,
       .meaning = message(
           "A link is turned in the surface further than a skin link can be; probably a wrong port or a cable."),
       .why = message("Gravity, as the two cells feel it, says that they are turned against each other in the "
                      "surface further than the mould lets them."),
       .what_to_do = message("Look at the two cells. If a cable joins them, or other ports than those that are named, "
                             "set the link aside. If not, check the axes of their sensors."),
       .remedies = {MuteLink, LightCell}},
      {.code = LinkNotRigid,
       .name = "link-not-rigid",
       .severity = Severity::Warning,
       .meaning = message("The two cells of a link moved against each other between poses; it is probably a joint."),
       .why = message(
           "The angle between the two cells was another one from pose to pose, by more than their readings err."),
       .what_to_do =
           message("If a joint lies between the two cells, set the link aside. If not, fix them in the mould and take "
                   "the poses again."),
       .remedies = {MuteLink, LightCell}},
      {.code = LinkDoesNotClose,
       .name = "link-does-not-close",
       .severity = Severity::Warning,
       .meaning =
           message("With all other links the ends of this link come to lie far apart: it is probably a cable, or "
                   "another link of the loop is. Muted."),
       .why = message("Where all other links are followed, the two ends of this one should meet, and they do not."),
       .what_to_do = message(
           "Look at the links of this loop for a cable. Set that one aside; if this one is sound, take it back."),
       .remedies = {MuteLink, LightCell}},
      {.code = LinkSetAside,
       .name = "link-set-aside",
       .severity = Severity::Info,
       .meaning = message("The operator set a link aside, as a cable for example; it is muted."),
       .why = message("Somebody set this link aside in this session."),
       .what_to_do = message("Nothing. Take the link back if it should count again."),
       .remedies = {MuteLink}},
      {.code = ContradictsModel,
       .name = "contradicts-model",
       .severity = Severity::Error,
       .meaning = message("The links of a patch turn as on no surface: axes or ports are not as in the cell model."),
       .why = message("A surface bends to either side. A twist to one side everywhere comes from a wrong "
                      "description of the cell."),
       .what_to_do = message("Compare the axes and the numbers of the ports in the cell model with a real cell."),
       .remedies = {}},
      {.code = TornSkin,
       .name = "torn-skin",
       .severity = Severity::Warning,
       .meaning =
           message("Links along one line fit no skin: the skin is torn there, or a joint or cables cross it. All "
                   "its links are named, end by end, and muted."),
       .why = message("The links lie side by side, and without them both sides fit."),
       .what_to_do = message("Look along the line of links. If a joint or cables cross it, leave them muted. If the "
                             "skin is whole there, check the cells beside it."),
       .remedies = {LightCell}},
      {.code = InsideOut,
       .name = "inside-out",
       .severity = Severity::Info,
       .meaning = message("Nearly all links bend inwards: the skin lies in a hollow, or it comes out inside out."),
       .why = message("A skin on the outside of a body bends outwards. Gravity cannot tell a hollow from a skin whose "
                      "accelerometers are all mirrored."),
       .what_to_do = message(
           "Say whether the skin lies on the outside of the body or in a hollow. On the outside, the axes of the "
           "accelerometers are not as in the cell model."),
       .remedies = {}},
      {.code = NoSamples,
       .name = "no-samples",
       .severity = Severity::Warning,
       .meaning = message("A cell has no usable reading in any enabled pose; it is placed through its links."),
       .why = message("The cell sent no readings that can be used in any pose that counts."),
       .what_to_do =
           message("Check the power and the contacts of the cell, and take the poses again. It may stay as it "
                   "is: it is less certain than the others then."),
       .remedies = {LightCell, TakePose}},
      {.code = MissingSamples,
       .name = "missing-samples",
       .severity = Severity::Info,
       .meaning = message("A cell has no reading in some enabled poses; it is placed from the others."),
       .why = message("The cell sent no readings that can be used while these poses were captured."),
       .what_to_do = message("Nothing has to be done. With these poses taken again the cell is known better."),
       .remedies = {RecapturePose, LightCell}},
      {.code = DeadSensor,
       .name = "dead-sensor",
       .severity = Severity::Error,
       .meaning = message("A cell's accelerometer reads nothing like gravity; the cell is placed through its links."),
       .why = message("At rest a sensor reads 1 g along some direction, and this one reads nothing like it."),
       .what_to_do = message("Replace the cell, or leave it as it is: it is less certain than the others then."),
       .remedies = {LightCell}},
      {.code = StuckSensor,
       .name = "stuck-sensor",
       .severity = Severity::Error,
       .meaning = message(
           "A cell's accelerometer does not change while the part moves; the cell is placed through its links."),
       .why = message("The part was turned from pose to pose, and what this sensor reads stayed the same."),
       .what_to_do = message("Replace the cell, or leave it as it is: it is less certain than the others then."),
       .remedies = {LightCell}},
      {.code = SaturatedSensor,
       .name = "saturated-sensor",
       .severity = Severity::Warning,
       .meaning = message("A reading lies at the end of the accelerometer's range; it is not used."),
       .why = message("At the end of its range a sensor can't tell how large a value is."),
       .what_to_do = message(
           "Take the pose again without a jolt. If it happens again, check the range that the sensor is set to."),
       .remedies = {RecapturePose, LightCell}},
      {.code = NoisySensor,
       .name = "noisy-sensor",
       .severity = Severity::Warning,
       .meaning = message("A cell's readings scatter far more than its sensor's noise and the other cells'."),
       .why = message("The part was still, as the other cells show, and the readings of this one scatter."),
       .what_to_do = message("Check that the cell sits firmly and that its power is steady, and take the poses again."),
       .remedies = {RecapturePose, LightCell}},
      {.code = WrongNorm,
       .name = "wrong-norm",
       .severity = Severity::Warning,
       .meaning = message("A cell's readings are further from 1 g than its sensor's offset and scale allow."),
       .why = message("At rest a reading is 1 g long, whatever its direction."),
       .what_to_do =
           message("Take the pose again and hold the part stiller: its motion adds to gravity, most of all far from "
                   "where it is held. If it happens again, check the sensor of the cell, and the scale in which "
                   "its readings are sent."),
       .remedies = {RecapturePose, LightCell}},
      {.code = DeadAxis,
       .name = "dead-axis",
       .severity = Severity::Error,
       .meaning =
           message("One axis of a cell's accelerometer does not follow gravity; the cell is placed through its links."),
       .why = message("From pose to pose two axes follow gravity, and the third does not."),
       .what_to_do = message("Replace the cell, or leave it as it is: it is less certain than the others then."),
       .remedies = {LightCell}},
      {.code = WrongGain,
       .name = "wrong-gain",
       .severity = Severity::Error,
       .meaning =
           message("A cell's accelerometer reads too much or too little in every pose; it is placed by its links."),
       .why = message(
           "At rest a reading is 1 g long, and the readings of this cell are too long or too short in every pose."),
       .what_to_do = message("Check the sensor of the cell, and the scale in which its readings are sent."),
       .remedies = {LightCell}},
      {.code = InconsistentSensor,
       .name = "inconsistent-sensor",
       .severity = Severity::Error,
       .meaning =
           message("A cell's readings fit no position of the cell in the patch; the cell is placed through its links."),
       .why = message("However the cell is placed in the patch, its readings contradict those of the others."),
       .what_to_do = message("Check that the cell is not loose, and that its axes are those of the cell model."),
       .remedies = {LightCell}},
      {.code = IdenticalReadings,
       .name = "identical-readings",
       .severity = Severity::Error,
       .meaning = message("Cells report the same readings, bit for bit; they are placed through their links."),
       .why = message("No two sensors read the same to the last bit: the readings of one cell were sent in the "
                      "name of another."),
       .what_to_do = message("Check the IDs of these cells, and how their data are passed on."),
       .remedies = {LightCell}},
      {.code = SwappedReadings,
       .name = "swapped-readings",
       .severity = Severity::Error,
       .meaning = message("Two neighbours fit with each other's readings; they are placed through their links."),
       .why = message("If the readings of the two cells are exchanged, they fit with those around them."),
       .what_to_do = message("Exchange the IDs of the two cells, or check how their data are passed on."),
       .remedies = {LightCell}},
      {.code = TurnedSensor,
       .name = "turned-sensor",
       .severity = Severity::Error,
       .meaning = message("A cell's readings are those of a cell that lies otherwise; it is placed through its links."),
       .why = message("The readings fit as soon as the cell is taken to lie otherwise."),
       .what_to_do =
           message("Look how the cell lies in the mould, and whether its sensor sits as the cell model says."),
       .remedies = {LightCell}},
      {.code = TurnedGroup,
       .name = "turned-group",
       .severity = Severity::Warning,
       .meaning =
           message("Cells read as if all of them were turned or mirrored alike against the others; their readings "
                   "are turned back."),
       .why = message("With one turn or reflection of their axes all links to the other cells are links of a skin."),
       .what_to_do = message("Compare these cells with the others: how they are mounted, and of which batch they are."),
       .remedies = {LightCell}},
      {.code = MovedCell,
       .name = "moved-cell",
       .severity = Severity::Error,
       .meaning = message("A cell turned against the others between two poses; it is placed through its links."),
       .why = message("From one pose on the readings fit another orientation of the cell than before."),
       .what_to_do = message("Fix the cell in the mould, and take the poses again."),
       .remedies = {LightCell, TakePose}},
      {.code = SuspiciousSensor,
       .name = "suspicious-sensor",
       .severity = Severity::Warning,
       .meaning = message("A cell's readings fit badly, and there are too few poses to say why; they are used."),
       .why = message("The readings fit worse than those of the other cells, and several causes would explain it."),
       .what_to_do = message("Take another pose: it tells more about the cause."),
       .remedies = {TakePose, LightCell}},
      {.code = SensorsUnlikeModel,
       .name = "sensors-unlike-model",
       .severity = Severity::Warning,
       .meaning = message("The errors of the accelerometers are together clearly larger than the cell model's sigmas."),
       .why = message(
           "Freed from all that is known, the readings still differ by more than the cell model's sigmas explain."),
       .what_to_do = message("Find out the errors with hexoderm-cli sensors, and write them into the cell model."),
       .remedies = {}},
      {.code = LeftOut,
       .name = "left-out",
       .severity = Severity::Info,
       .meaning = message("A cell was left out on request; it is placed through its links."),
       .why = message("It was asked for when this result was solved."),
       .what_to_do = message("Nothing. Solve again with the cell if it should count."),
       .remedies = {LightCell}},
      {.code = SampleOfUnknownCell,
       .name = "sample-of-unknown-cell",
       .severity = Severity::Warning,
       .meaning = message("A pose holds a reading of a cell that is not in the skin; it is not used."),
       .why = message("The pose was captured with other cells than the skin has, or an ID was misread."),
       .what_to_do = message("Connect again, so that the list of cells is read anew, and take the pose again."),
       .remedies = {RecapturePose, DisablePose}},
      {.code = DuplicateSample,
       .name = "duplicate-sample",
       .severity = Severity::Warning,
       .meaning = message("A pose holds two readings of one cell; the first counts."),
       .why = message("A cell has one reading in a pose, and nothing says which of the two is right."),
       .what_to_do = message("Take the pose again if the cell does not fit."),
       .remedies = {RecapturePose, LightCell}},
      {.code = DuplicatePose,
       .name = "duplicate-pose",
       .severity = Severity::Warning,
       .meaning = message("Two poses carry the same ID."),
       .why = message("Every pose has an ID of its own; files that were joined can hold one twice."),
       .what_to_do = message("Disable one of the two if they are the same."),
       .remedies = {DisablePose}},
      {.code = NoPoses,
       .name = "no-poses",
       .severity = Severity::Warning,
       .meaning = message("There is no enabled pose: the placement follows from the ports alone."),
       .why = message(
           "The ports say how cells lie beside each other in a plane. Only gravity tells how the surface bends."),
       .what_to_do = message("Hold the part still, and take a first pose."),
       .remedies = {TakePose}},
      {.code = TooFewDirections,
       .name = "too-few-directions",
       .severity = Severity::Warning,
       .meaning = message("The poses show gravity along too few directions to fix every rotation."),
       .why = message("About a line along which gravity was always seen, a cell could be turned in any way."),
       .what_to_do = message("Turn the part by about 90 degrees about a horizontal axis, and take a pose."),
       .remedies = {TakePose}},
      {.code = RepeatedPose,
       .name = "repeated-pose",
       .severity = Severity::Info,
       .meaning = message("Two poses show gravity along nearly the same line, which adds little."),
       .why = message("Gravity along a line that was seen before tells nothing new about the shape."),
       .what_to_do = message("Nothing has to be done. Turn the part further before the next pose."),
       .remedies = {TakePose}},
      {.code = PartMoved,
       .name = "part-moved",
       .severity = Severity::Warning,
       .meaning = message("Most cells scattered far beyond their noise in this pose: the part was probably moving."),
       .why = message("While a part moves, its sensors feel the motion beside gravity."),
       .what_to_do = message("Take the pose again and hold the part still, or disable it."),
       .remedies = {RecapturePose, DisablePose}},
      {.code = InconsistentPose,
       .name = "inconsistent-pose",
       .severity = Severity::Warning,
       .meaning = message("The cells contradict each other in one pose far more than in the others; the part moved."),
       .why =
           message("In the other poses the cells agree: in this one the part moved, or something pressed on the skin."),
       .what_to_do = message("Take the pose again and let nothing touch the skin, or disable it."),
       .remedies = {RecapturePose, DisablePose}},
      {.code = NotConverged,
       .name = "not-converged",
       .severity = Severity::Warning,
       .meaning =
           message("The joint estimate of a patch ended before its optimum; placements and stated uncertainties are "
                   "preliminary."),
       .why = message("The estimate goes on in steps as long as they make the shape more probable, and the steps "
                      "ran out."),
       .what_to_do =
           message("Take another pose: two alone often leave open where the optimum is. Until then rely on no "
                   "figure of this patch."),
       .remedies = {TakePose}},
      {.code = PoorFit,
       .name = "poor-fit",
       .severity = Severity::Error,
       .meaning = message("After all that was found the readings or links still do not fit the model: the result is "
                          "not to be trusted."),
       .why = message("What is left unexplained is far larger than the model's own uncertainties can explain."),
       .what_to_do =
           message("Check the cell model and the findings, and take the poses again with the part held still."),
       .remedies = {TakePose}},
  });
  static_assert(the_table.size() == enumeratorCount<FindingCode>());
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
