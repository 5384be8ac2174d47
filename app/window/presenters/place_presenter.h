#pragma once

#include "app/window/presenters/place_decisions.h"
#include "app/window/presenters/place_sentences.h"
#include "app/window/session/place_facts.h"

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
  [[nodiscard]] RobotPicture picture() const;
  void take(const QString& fault);

  /// By what the patch is moved by hand; nullopt: it can't be.
  [[nodiscard]] std::optional<HandPlace::Where> handle() const;
  /// Whether there is anything to be moved.
  bool takeInHand();
  template <class Move>
  void moveInHand(Move move);
  /// It is to lie where it is: the fit begins there, and what comes of it becomes the place.
  void lay();
  void leaveAlone();

  Views views_;
  SessionController& controller_;
  Placing& placing_;
  PlaceFacts facts_;
  PlaceFaults faults_;
  PlaceSentences sentences_;
  PlaceDecisions decisions_;
  std::optional<RobotDescription> asked_;   ///< whose file is read, or was
  std::optional<RobotDescription> picked_;  ///< by the operator, and being read; the session gets it if it can be
  std::optional<LinksQuestion> links_question_;
  std::optional<PlacesQuestion> places_question_;
  QString joints_file_;  ///< of the last table that was read
  HandPlace hand_;
  bool lays_ = false;   ///< what the fit makes of it becomes the place
  int open_step_ = -1;  ///< as showRobot() last saw it
  /// The patch, by its origin cell, and the link that the camera went up to last.
  std::optional<std::pair<CellId, std::size_t>> looked_at_;
};

}  // namespace hexoderm
