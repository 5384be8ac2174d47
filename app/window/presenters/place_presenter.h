#pragma once

#include "app/window/session/hand_place.h"
#include "app/window/session/placing.h"

#include <QObject>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QWidget;

namespace hexoderm {

class RobotView;
class SessionController;
class StepPanel;

/// The step "Place on the robot": asks for the robot and its joint angles, has links and places found for what the
/// session holds, and writes the operator's decisions into it. The robot takes the place of the patch in the middle of
/// the window while this step is open.
class PlacePresenter : public QObject {
  Q_OBJECT

 public:
  struct Views {
    QWidget& window;  ///< dialogs belong to it
    StepPanel& steps;
    PlacePanel& panel;
    RobotView& robot;
    QWidget& middle;  ///< whose place the robot takes
  };
  /// All outlive the presenter.
  PlacePresenter(const Views& views, SessionController& controller, Placing& placing);

  /// The session was solved anew.
  void setReconstruction(std::shared_ptr<const Reconstruction> reconstruction);
  void refresh();
  /// A URDF or a table of joint angles that was dropped onto the window; false: it is neither, or nothing can be
  /// placed.
  bool takeFile(const QString& path);

 private:
  /// What links were looked for with.
  struct LinksQuestion {
    std::shared_ptr<const LoadedRobot> robot;
    std::shared_ptr<const Reconstruction> solved;
    std::map<PoseId, JointAngles> angles;
    std::map<CellId, std::string> chosen;
    friend bool operator==(const LinksQuestion&, const LinksQuestion&) = default;
  };
  /// What places were looked for with, the patch's own decisions as text.
  struct PlacesQuestion {
    std::shared_ptr<const LoadedRobot> robot;
    std::shared_ptr<const Reconstruction> solved;
    std::shared_ptr<const LinksResult> links;
    std::vector<std::string> decisions;
    friend bool operator==(const PlacesQuestion&, const PlacesQuestion&) = default;
  };

  void connectPanel();
  void connectWork();
  void connectEdits();
  void connectHand();
  void askForRobot();
  void askForPackage();
  void askForJoints();
  void pickRobot(const RobotDescription& description);
  void readJoints(const QString& path);
  void setAngles(const std::vector<TypedAngle>& angles);

  void followRobot();
  void findLinks();
  void findPlaces();
  void forgetPlaces();
  void showStand();
  void showRobot();
  void lookAtWhatIsNew(const RobotPicture& drawn);

  [[nodiscard]] QString whyNot() const;
  [[nodiscard]] const PatchReconstruction* patch() const;
  [[nodiscard]] const PatchReconstruction* patchOf(CellId cell) const;
  [[nodiscard]] const PatchLinks* linksOf(const PatchReconstruction& patch) const;
  /// What is decided about a patch, as far as anything is.
  [[nodiscard]] PatchPlacement decided(const PatchReconstruction& patch) const;
  /// The link that it is taken to be on: the decided one, or the only one that fits. Empty where it is open.
  [[nodiscard]] std::string linkOf(const PatchReconstruction& patch) const;
  [[nodiscard]] std::map<PoseId, JointAngles> angles() const;
  [[nodiscard]] JointAngles shownAngles() const;
  [[nodiscard]] JointSheet sheet() const;
  /// The patches that are placed together with one, because distances join them: itself first.
  [[nodiscard]] std::vector<const PatchReconstruction*> placedWith(const PatchReconstruction& patch) const;
  [[nodiscard]] std::optional<PlaceTask> taskFor(const PatchReconstruction& patch) const;
  [[nodiscard]] int rowOfPlace() const;
  [[nodiscard]] VerifySentence robotInWords() const;
  [[nodiscard]] VerifySentence jointsInWords() const;
  [[nodiscard]] VerifySentence linkSaid(const PatchReconstruction& patch) const;
  [[nodiscard]] VerifySentence placesSaid() const;
  [[nodiscard]] RobotPicture picture() const;
  void addPatches(RobotPicture& picture) const;
  [[nodiscard]] const PlaceCandidate* shownCandidate() const;
  void addChoices(PlaceStand& stand) const;

  void decide(std::vector<PatchPlacement> placements, const QString& text);
  void chooseLink(const QString& link);
  void addPoint(const KnownPoint& point);
  void addDistance(const KnownDistance& distance);
  void choosePlace(int row, const QString& text);

  /// By what the patch is moved by hand; nullopt: it can't be.
  [[nodiscard]] std::optional<HandPlace::Where> handle() const;
  /// Whether there is anything to be moved.
  bool takeInHand();
  template <class Move>
  void moveInHand(Move move);
  /// It is to lie where it is: the fit begins there, and what comes of it becomes the place.
  void lay();
  void leaveAlone();
  [[nodiscard]] bool isPut(const PatchReconstruction& patch) const;

  Views views_;
  SessionController& controller_;
  Placing& placing_;
  std::shared_ptr<const Reconstruction> solved_;
  std::optional<RobotDescription> asked_;   ///< whose file is read, or was
  std::optional<RobotDescription> picked_;  ///< by the operator, and being read; the session gets it if it can be
  std::shared_ptr<const LoadedRobot> robot_;
  std::shared_ptr<const LinksResult> links_;
  std::shared_ptr<const PlaceResult> places_;
  std::optional<LinksQuestion> links_question_;
  std::optional<PlacesQuestion> places_question_;
  QString robot_fault_;
  QString joints_fault_;
  QString links_fault_;
  QString places_fault_;
  QString places_remark_;
  QString known_fault_;
  QString joints_file_;  ///< of the last table that was read
  CellId patch_{0};      ///< the origin cell of the patch that is spoken of
  quint32 pose_ = 0;     ///< in which the robot is drawn
  int preview_ = -1;     ///< the row of the place that is pointed at
  HandPlace hand_;
  std::optional<PutPlace> put_;  ///< where a patch was put by hand; the fit begins there too
  bool lays_ = false;            ///< what the fit makes of it becomes the place
  int open_step_ = -1;           ///< as showRobot() last saw it
  /// The patch, by its origin cell, and the link that the camera went up to last.
  std::optional<std::pair<CellId, std::size_t>> looked_at_;
};

}  // namespace hexoderm
