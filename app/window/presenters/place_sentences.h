#pragma once

#include "app/window/session/place_facts.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/robots/joint_check.h"
#include "widgets/robot/place_words.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

namespace hexoderm {

/// What the step "Place on the robot" says of what is known, in the operator's language.
class PlaceSentences {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::PlaceSentences)

 public:
  /// They are read when something is asked, and outlive this.
  explicit PlaceSentences(const PlaceFacts& facts) : facts_(facts) {}

  [[nodiscard]] VerifySentence robot() const {
    std::vector<VerifySentence> sentences;
    if (!facts_.faults.robot.isEmpty()) sentences.push_back({Tone::Bad, facts_.faults.robot});
    if (facts_.robot) {
      sentences.push_back({Tone::Good, tr("%1, %2 links, from %3.")
                                           .arg(QString::fromStdString(facts_.robot->model.name()))
                                           .arg(facts_.robot->model.links().size())
                                           .arg(fileNameOf(facts_.robot->description))});
      sentences.insert(sentences.end(), facts_.robot->findings.begin(), facts_.robot->findings.end());
    } else if (sentences.empty()) {
      sentences.push_back({Tone::Neutral, tr("Not chosen yet.")});
    }
    return together(sentences);
  }

  [[nodiscard]] VerifySentence joints() const {
    if (!facts_.robot || !facts_.controller.session()) return {};
    std::vector<VerifySentence> sentences;
    if (!facts_.faults.joints.isEmpty()) sentences.push_back({Tone::Bad, facts_.faults.joints});
    const std::map<PoseId, JointAngles> known = facts_.angles();
    const std::size_t poses = facts_.controller.session()->poses().size();
    if (known.empty()) {
      sentences.push_back(
          {Tone::Caution,
           tr("No pose has joint angles, so that no link can be told. A link can be chosen all the same.")});
    } else {
      sentences.push_back({known.size() < poses ? Tone::Caution : Tone::Good,
                           tr("%1 of %2 poses have joint angles.").arg(known.size()).arg(poses)});
      std::vector<JointAngles> all;
      for (const auto& [pose, of_pose] : known) all.push_back(of_pose);
      const JointDoubts doubts = doubtsOf(facts_.robot->model, all);
      if (doubts.probably_degrees) sentences.push_back({Tone::Bad, words(*doubts.probably_degrees)});
      for (const BeyondLimits& beyond : doubts.beyond_limits)
        sentences.push_back({Tone::Caution, words(beyond.message)});
    }
    if (facts_.links) {
      for (const Message& finding : facts_.links->findings) sentences.push_back({Tone::Caution, words(finding)});
    }
    return together(sentences);
  }

  [[nodiscard]] VerifySentence link(const PatchReconstruction& patch) const {
    if (!facts_.faults.links.isEmpty()) return {Tone::Bad, facts_.faults.links};
    if (const PatchLinks* links = facts_.linksOf(patch)) return linkText(*links);
    if (facts_.links) return {Tone::Caution, tr("This patch saw gravity in no pose that has joint angles.")};
    return {};
  }

  [[nodiscard]] VerifySentence places() const {
    if (!facts_.faults.places.isEmpty()) return {Tone::Bad, facts_.faults.places};
    if (!facts_.places)
      return {facts_.faults.places_remark.isEmpty() ? Tone::Neutral : Tone::Caution, facts_.faults.places_remark};
    const int row = facts_.preview >= 0 ? facts_.preview : std::max(0, facts_.rowOfPlace());
    VerifySentence said = placesText(*facts_.places, static_cast<std::size_t>(row));
    if (!facts_.faults.places_remark.isEmpty()) said.text += QLatin1Char('\n') + facts_.faults.places_remark;
    return said;
  }

  /// Of a patch that is being moved by hand.
  [[nodiscard]] static VerifySentence hand(const HandPlace& hand) {
    const VerifySentence keys{
        Tone::Neutral, tr("Pull it by the mouse; or arrow keys slide it by 1 mm, Page Up and Page Down turn it by "
                          "1°, with Shift by ten times as much. Return lays it there, Escape leaves it where it "
                          "was.")};
    const std::optional<Message> objection = hand.objection();
    return objection ? together({{Tone::Caution, words(*objection)}, keys}) : keys;
  }

  /// The poses, patches and links that can be chosen.
  void addChoices(PlaceStand& stand) const {
    for (const auto& [pose, of_pose] : facts_.angles()) {
      stand.poses.push_back({pose.value(), tr("Pose %1").arg(pose.value())});
    }
    if (stand.poses.empty()) stand.poses.push_back({0, tr("All joints at 0")});
    const auto is_there =
        std::ranges::any_of(stand.poses, [this](const PlaceStand::Choice& choice) { return choice.id == facts_.pose; });
    stand.pose = is_there ? facts_.pose : stand.poses.front().id;
    for (const PatchReconstruction& of : facts_.solved->patches) {
      if (of.cells.empty()) continue;
      QString text = of.cells.size() == 1
                         ? tr("Cell %1 alone").arg(of.origin.value())
                         : tr("Patch of cell %1, %2 cells").arg(of.origin.value()).arg(of.cells.size());
      if (facts_.decided(of).place) text += QStringLiteral(" · ✓ ") + QString::fromStdString(facts_.linkOf(of));
      stand.patches.push_back({of.origin.value(), text});
    }
    stand.patch = facts_.spoken_of.value();
    if (!facts_.robot) return;
    for (const RobotLink& link : facts_.robot->model.links()) stand.other_links << QString::fromStdString(link.name);
  }

 private:
  static QString fileNameOf(const RobotDescription& description) {
    return QFileInfo(QString::fromStdString(description.urdf)).fileName();
  }

  const PlaceFacts& facts_;
};

}  // namespace hexoderm
