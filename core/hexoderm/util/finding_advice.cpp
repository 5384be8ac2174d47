#include "hexoderm/util/finding_advice.h"

#include <array>

namespace hexoderm {
namespace {

/// Built at its first use, for a message is no constant expression.
const auto& adviceTable() {
  using enum FindingCode;
  using enum FindingRemedy;
  static const std::array the_table = {
      FindingAdvice{DuplicateCell,
                    message("The device's list names one ID twice, and two cells can't share an ID."),
                    message("Give one of the two cells another ID, and connect again."),
                    {LightCell}},
      FindingAdvice{ReservedCellId,
                    message("ID 0 stands for nothing, and the interface's ID for the computer: a cell with such an ID "
                            "can't be told from them."),
                    message("Give the cell another ID, and connect again."),
                    {}},
      FindingAdvice{UnknownPort,
                    message("The port that was reported is not among those of the cell model."),
                    message("Check that the cell model is that of this skin. If it is, the report of the cell is "
                            "wrong: connect again."),
                    {LightCell}},
      FindingAdvice{
          UnknownCell,
          message("A cell reports a neighbour that did not report itself: it has no power, or its report was lost."),
          message("Check the power and the contacts of the missing cell, and connect again."),
          {LightCell}},
      FindingAdvice{
          SelfLink,
          message(
              "A link joins two cells. One that ends where it begins comes from a short circuit or a wrong report."),
          message("Check the ports of this cell, and connect again."),
          {LightCell}},
      FindingAdvice{OneSidedLink,
                    message("A sound link is seen from both of its ends, and here one end sees nothing: a contact is "
                            "loose, or a report was lost."),
                    message("Check the contacts between the two cells, and connect again. If nothing joins them there, "
                            "leave it as it is."),
                    {LightCell}},
      FindingAdvice{
          ContradictoryLink,
          message("The two cells name different ports, or different neighbours, for what should be one link."),
          message("Check how the two cells are joined, and connect again."),
          {LightCell}},
      FindingAdvice{DuplicateLink,
                    message("A port leads to one neighbour at most, and two cells are joined once at most."),
                    message("Check the ports that are named for a short circuit or a wrong cable, and connect again."),
                    {LightCell}},
      FindingAdvice{ForbiddenPortPair,
                    message("Cells side by side in the mould can't touch with these two ports."),
                    message("If a cable joins the two cells, leave it as it is. If not, check the cell model."),
                    {LightCell}},
      FindingAdvice{InterfaceLink,
                    message("The computer's interface is at this port, and it is no cell."),
                    message("Nothing: this is as it should be."),
                    {}},
      FindingAdvice{BodyPartBoundary,
                    message("Body parts move against each other, so a link between them is not rigid."),
                    message("Nothing, if the names of the body parts are right."),
                    {}},
      FindingAdvice{
          ImplausibleBend,
          message(
              "Gravity, as the two cells feel it, says that they stand at a steeper angle than the mould lets them."),
          message("Look at the two cells. If a cable joins them, or a joint lies between them, set the link aside. If "
                  "they lie side by side in the mould, check the axes of their sensors."),
          {MuteLink, LightCell}},
      FindingAdvice{ImplausibleTwist,
                    message("Gravity, as the two cells feel it, says that they are twisted about the line between them "
                            "further than the mould lets them."),
                    message("Look at the two cells. If a cable joins them, or other ports than those that are named, "
                            "set the link aside. If not, check the axes of their sensors."),
                    {MuteLink, LightCell}},
      FindingAdvice{ImplausibleYaw,
                    message("Gravity, as the two cells feel it, says that they are turned against each other in the "
                            "surface further than the mould lets them."),
                    message("Look at the two cells. If a cable joins them, or other ports than those that are named, "
                            "set the link aside. If not, check the axes of their sensors."),
                    {MuteLink, LightCell}},
      FindingAdvice{
          LinkNotRigid,
          message(
              "The angle between the two cells was another one from pose to pose, by more than their readings err."),
          message("If a joint lies between the two cells, set the link aside. If not, fix them in the mould and take "
                  "the poses again."),
          {MuteLink, LightCell}},
      FindingAdvice{
          LinkDoesNotClose,
          message("Where all other links are followed, the two ends of this one should meet, and they do not."),
          message(
              "Look at the links of this loop for a cable. Set that one aside; if this one is sound, take it back."),
          {MuteLink, LightCell}},
      FindingAdvice{LinkSetAside,
                    message("Somebody set this link aside in this session."),
                    message("Nothing. Take the link back if it should count again."),
                    {MuteLink}},
      FindingAdvice{ContradictsModel,
                    message("A surface bends to either side. A twist to one side everywhere comes from a wrong "
                            "description of the cell."),
                    message("Compare the axes and the numbers of the ports in the cell model with a real cell."),
                    {}},
      FindingAdvice{NoSamples,
                    message("The cell sent no readings that can be used in any pose that counts."),
                    message("Check the power and the contacts of the cell, and take the poses again. It may stay as it "
                            "is: it is less certain than the others then."),
                    {LightCell, TakePose}},
      FindingAdvice{MissingSamples,
                    message("The cell sent no readings that can be used while these poses were captured."),
                    message("Nothing has to be done. With these poses taken again the cell is known better."),
                    {RecapturePose, LightCell}},
      FindingAdvice{DeadSensor,
                    message("At rest a sensor reads 1 g along some direction, and this one reads nothing like it."),
                    message("Replace the cell, or leave it as it is: it is less certain than the others then."),
                    {LightCell}},
      FindingAdvice{StuckSensor,
                    message("The part was turned from pose to pose, and what this sensor reads stayed the same."),
                    message("Replace the cell, or leave it as it is: it is less certain than the others then."),
                    {LightCell}},
      FindingAdvice{
          SaturatedSensor,
          message("At the end of its range a sensor can't tell how large a value is."),
          message(
              "Take the pose again without a jolt. If it happens again, check the range that the sensor is set to."),
          {RecapturePose, LightCell}},
      FindingAdvice{NoisySensor,
                    message("The part was still, as the other cells show, and the readings of this one scatter."),
                    message("Check that the cell sits firmly and that its power is steady, and take the poses again."),
                    {RecapturePose, LightCell}},
      FindingAdvice{
          WrongNorm,
          message("At rest a reading is 1 g long, whatever its direction."),
          message("Take the pose again and hold the part stiller: its motion adds to gravity, most of all far from "
                  "where it is held. If it happens again, check the sensor of the cell, and the scale in which "
                  "its readings are sent."),
          {RecapturePose, LightCell}},
      FindingAdvice{DeadAxis,
                    message("From pose to pose two axes follow gravity, and the third does not."),
                    message("Replace the cell, or leave it as it is: it is less certain than the others then."),
                    {LightCell}},
      FindingAdvice{
          WrongGain,
          message(
              "At rest a reading is 1 g long, and the readings of this cell are too long or too short in every pose."),
          message("Check the sensor of the cell, and the scale in which its readings are sent."),
          {LightCell}},
      FindingAdvice{InconsistentSensor,
                    message("However the cell is placed in the patch, its readings contradict those of the others."),
                    message("Check that the cell is not loose, and that its axes are those of the cell model."),
                    {LightCell}},
      FindingAdvice{IdenticalReadings,
                    message("No two sensors read the same to the last bit: the readings of one cell were sent in the "
                            "name of another."),
                    message("Check the IDs of these cells, and how their data are passed on."),
                    {LightCell}},
      FindingAdvice{SwappedReadings,
                    message("If the readings of the two cells are exchanged, they fit with those around them."),
                    message("Exchange the IDs of the two cells, or check how their data are passed on."),
                    {LightCell}},
      FindingAdvice{TurnedSensor,
                    message("The readings fit as soon as the cell is taken to lie otherwise."),
                    message("Look how the cell lies in the mould, and whether its sensor sits as the cell model says."),
                    {LightCell}},
      FindingAdvice{MovedCell,
                    message("From one pose on the readings fit another orientation of the cell than before."),
                    message("Fix the cell in the mould, and take the poses again."),
                    {LightCell, TakePose}},
      FindingAdvice{
          SuspiciousSensor,
          message("The readings fit worse than those of the other cells, and several causes would explain it."),
          message("Take another pose: it tells more about the cause."),
          {TakePose, LightCell}},
      FindingAdvice{
          SensorsUnlikeModel,
          message(
              "Freed from all that is known, the readings still differ by more than the cell model's sigmas explain."),
          message("Find out the errors with hexoderm-cli sensors, and write them into the cell model."),
          {}},
      FindingAdvice{LeftOut,
                    message("It was asked for when this result was solved."),
                    message("Nothing. Solve again with the cell if it should count."),
                    {LightCell}},
      FindingAdvice{SampleOfUnknownCell,
                    message("The pose was captured with other cells than the skin has, or an ID was misread."),
                    message("Connect again, so that the list of cells is read anew, and take the pose again."),
                    {RecapturePose, DisablePose}},
      FindingAdvice{DuplicateSample,
                    message("A cell has one reading in a pose, and nothing says which of the two is right."),
                    message("Take the pose again if the cell does not fit."),
                    {RecapturePose, LightCell}},
      FindingAdvice{DuplicatePose,
                    message("Every pose has an ID of its own; files that were joined can hold one twice."),
                    message("Disable one of the two if they are the same."),
                    {DisablePose}},
      FindingAdvice{
          NoPoses,
          message(
              "The ports say how cells lie beside each other in a plane. Only gravity tells how the surface bends."),
          message("Hold the part still, and take a first pose."),
          {TakePose}},
      FindingAdvice{TooFewDirections,
                    message("About a line along which gravity was always seen, a cell could be turned in any way."),
                    message("Turn the part by about 90 degrees about a horizontal axis, and take a pose."),
                    {TakePose}},
      FindingAdvice{RepeatedPose,
                    message("Gravity along a line that was seen before tells nothing new about the shape."),
                    message("Nothing has to be done. Turn the part further before the next pose."),
                    {TakePose}},
      FindingAdvice{PartMoved,
                    message("While a part moves, its sensors feel the motion beside gravity."),
                    message("Take the pose again and hold the part still, or disable it."),
                    {RecapturePose, DisablePose}},
      FindingAdvice{
          InconsistentPose,
          message("In the other poses the cells agree: in this one the part moved, or something pressed on the skin."),
          message("Take the pose again and let nothing touch the skin, or disable it."),
          {RecapturePose, DisablePose}},
      FindingAdvice{NotConverged,
                    message("The estimate goes on in steps as long as they make the shape more probable, and the steps "
                            "ran out."),
                    message("Take another pose: two alone often leave open where the optimum is. Until then rely on no "
                            "figure of this patch."),
                    {TakePose}},
  };
  static_assert(the_table.size() == static_cast<std::size_t>(NotConverged) + 1);
  return the_table;
}

}  // namespace

std::span<const FindingAdvice> findingAdvice() { return adviceTable(); }

const FindingAdvice& adviceOn(FindingCode code) { return adviceTable().at(static_cast<std::size_t>(code)); }

}  // namespace hexoderm
