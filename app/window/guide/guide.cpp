#include "app/window/guide/guide.h"

#include "app/window/guide/actions.h"
#include "app/window/session/session_controller.h"
#include "hexoderm/solve/metrics/assess.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/words/formatting.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

namespace hexoderm {
namespace {

struct Guide {
  Q_DECLARE_TR_FUNCTIONS(hexoderm::Guide)
};

QAction* bestAction(const SessionController& controller, const WindowActions& actions) {
  if (controller.isEmpty()) return actions.demo;
  const Reconstruction* result = controller.reconstruction().get();
  if (controller.liveSession().isRobotOn()) return actions.robot;
  if (controller.wasCancelled()) return actions.solve_again;
  if (actions.retake->isEnabled()) return actions.retake;
  if (controller.liveSession().wantsMorePoses())
    return controller.liveSession().canTurn() ? actions.robot : actions.show_next_pose;
  if (!result || (controller.session() && !result->assessment.isUsable())) return actions.connect_skin;
  const Finding* finding = worstFinding(*result);
  return finding && finding->severity == Severity::Error ? actions.show_finding : actions.export_to;
}

QString findingsText(const Reconstruction& reconstruction) {
  const std::size_t count = reconstruction.findings.size();
  if (count == 0) return Guide::tr("no findings");
  return count == 1 ? Guide::tr("1 finding") : Guide::tr("%1 findings").arg(count);
}

/// Nothing more will come, and no use to wait.
bool isOver(const LiveSource& live) {
  return live.status().state == SourceState::Ended || live.status().state == SourceState::Incompatible;
}
/// A skin is asked for its cells, and has not told them yet.
bool isTried(const SessionController& controller) {
  return controller.liveSession().source().isRunning() && !controller.liveSession().isLive();
}
/// A session in which nothing was captured: what is shown was not measured.
bool hasNoPose(const SessionController& controller) { return controller.session() && controller.enabledPoses() == 0; }
bool hasReadings(const SessionController& controller) {
  return !controller.liveSession().source().preview().means.empty();
}
/// A skin is connected and has not sent any readings yet.
bool isAwaited(const SessionController& controller) {
  return controller.liveSession().isLive() &&
         controller.liveSession().source().status().state == SourceState::Streaming && !hasReadings(controller);
}
/// A skin that does not send, though it has said which cells it has and its stream has not ended: nothing goes on until
/// it sends again.
bool fellSilent(const SessionController& controller) {
  const SourceState state = controller.liveSession().source().status().state;
  if (!controller.liveSession().isLive() || state == SourceState::Streaming || state == SourceState::Ended)
    return false;
  // One that has just connected is waited for.
  return hasReadings(controller) || state == SourceState::Silent || state == SourceState::Incompatible;
}
void say(Step& step, Readiness readiness, const QString& because) {
  step.readiness = readiness;
  step.because = because;
}

/// There is a session, and no result of it will come.
bool hasFailed(const SessionController& controller) {
  return controller.session() && !controller.reconstruction() && !controller.isSolving();
}

/// A result that comes by itself is waited for; everything else blocks.
void sayNoResult(Step& step, const SessionController& controller) {
  const QString awaited = describeAwaited(controller);
  if (awaited.isEmpty()) {
    say(step, Readiness::Blocked, Guide::tr("There is no skin yet."));
  } else {
    say(step, hasFailed(controller) ? Readiness::Blocked : Readiness::Waiting, awaited);
  }
}

/// Without a result it waits for one, as `waits` says.
Step stepOfResult(const SessionController& controller, const QString& title, const QString& waits) {
  Step step;
  step.title = title;
  if (controller.reconstruction()) return step;
  step.why = waits;
  sayNoResult(step, controller);
  return step;
}

/// Explains the step by its action: `because`, or the reason why the action can't be used.
void sayOf(Step& step, const QAction& action, const QString& because) {
  if (action.isEnabled()) {
    say(step, Readiness::Ready, because);
  } else {
    say(step, Readiness::Blocked, action.toolTip() + QLatin1Char('.'));
  }
}

/// Ready, if anything was captured.
void sayOfPoses(Step& step, const SessionController& controller, const QString& because) {
  if (hasNoPose(controller)) {
    say(step, Readiness::Blocked, Guide::tr("No pose has been captured yet."));
  } else {
    say(step, Readiness::Ready, because);
  }
}

Step connectStep(const SessionController& controller, const WindowActions& actions) {
  Step step;
  step.title = Guide::tr("Connect");
  step.actions = {actions.demo, actions.robot_demo, actions.connect_skin, actions.open};
  const LiveSource& source = controller.liveSession().source();
  if (source.isRunning()) step.actions = {actions.disconnect_skin};
  if (isTried(controller)) {
    step.actions.push_back(actions.connect_skin);
    step.state = StepState::Current;
    step.note = source.address();
    step.what = Guide::tr("Check that the device is switched on, and that its address is right.");
    step.why = Guide::tr("The steps go on when the skin has said which cells it has.");
    if (isOver(source)) {
      step.what = Guide::tr("Disconnect, and connect to another skin or recording.");
      step.why = Guide::tr("Nothing more will come from this one.");
    }
    say(step, isOver(source) ? Readiness::Blocked : Readiness::Waiting, words(source.status().message));
    return step;
  }
  if (controller.isEmpty()) {
    step.state = StepState::Current;
    step.what = Guide::tr("Start the demo skin, connect to a skin, or open a session or a calibration.");
    step.why = Guide::tr(
        "A file can also be dropped onto this window. The demo is a simulation of 17 cells on a "
        "cylinder; everything can be tried with it.");
    say(step, Readiness::Waiting, Guide::tr("Nothing is connected and nothing is open yet."));
    return step;
  }
  step.state = StepState::Done;
  step.note = controller.file().name();
  if (controller.liveSession().isDemo()) {
    step.why = Guide::tr("A simulated skin in a simulated hand. Its readings err as those of a real skin do.");
  } else {
    step.why = controller.session() ? words(controller.session()->source().text)
                                    : words(controller.reconstruction()->source.text);
  }
  if (controller.liveSession().isLive()) {
    if (source.status().state != SourceState::Streaming) {
      say(step, Readiness::Blocked, words(source.status().message));
    } else {
      say(step, Readiness::Ready,
          hasReadings(controller) ? Guide::tr("The skin has said which cells it has, and sends.")
                                  : Guide::tr("The skin has said which cells it has."));
    }
  } else {
    say(step, Readiness::Ready,
        controller.session() ? Guide::tr("A session is open.") : Guide::tr("A calibration is open."));
  }
  return step;
}

Step checkStep(const SessionController& controller, const WindowActions& actions, const SkinCheck& check) {
  Step step = stepOfResult(controller, Guide::tr("Check the skin"), Guide::tr("Waits for a skin."));
  const Reconstruction* result = controller.reconstruction().get();
  if (!result) return step;
  step.note = words(sizeText(*result));
  if (controller.liveSession().isLive()) {
    step.state = check.ready ? StepState::Done : StepState::Current;
    const Readiness not_yet = isAwaited(controller) ? Readiness::Waiting : Readiness::Blocked;
    say(step, check.ready ? Readiness::Ready : not_yet, words(check.because) + QLatin1Char('.'));
  } else {
    step.state = StepState::Done;
    say(step, Readiness::Ready, Guide::tr("The cells and links are those of the file."));
  }
  step.what = Guide::tr("Compare the skin graph (G makes it large) with the skin in front of you.");
  step.why = Guide::tr(
      "Every cell and every link should be there. What was reported but can't be a skin link is listed "
      "under Findings and kept out.");
  if (controller.liveSession().isLive()) step.actions = {actions.light_cell};
  return step;
}

Step captureStep(const SessionController& controller, const WindowActions& actions) {
  Step step;
  step.title = Guide::tr("Capture poses");
  const Reconstruction* result = controller.reconstruction().get();
  if (!controller.session()) {
    if (result) {
      step.state = StepState::Done;
      step.note = posesText(result->poses.size());
      step.why = Guide::tr("A calibration is open. It holds the result; the poses are in its session.");
    } else {
      step.why = Guide::tr("Waits for a skin.");
    }
    sayOf(step, *actions.capture, {});
    return step;
  }
  const bool more = controller.liveSession().wantsMorePoses();
  step.note = posesText(controller.enabledPoses());
  if (controller.liveSession().canTurn())
    step.actions = {actions.robot, actions.live_mode};
  else if (controller.liveSession().isLive())
    step.actions = {actions.live_mode};
  step.state = more || (result && !result->assessment.isUsable()) ? StepState::Current : StepState::Done;
  if (isAwaited(controller)) step.state = StepState::Waiting;
  // A connected skin has a panel of its own, which says what to do and why.
  if (actions.capture->isEnabled() && isAwaited(controller)) {
    say(step, Readiness::Waiting, Guide::tr("The first readings are on their way."));
  } else {
    sayOf(step, *actions.capture, Guide::tr("The skin sends."));
  }
  if (controller.liveSession().isLive()) {
    if (controller.indexToRetake()) {
      step.what = words(result->assessment.next_action);
      step.actions.insert(step.actions.begin(), actions.retake);
    }
    return step;
  }
  if (result && step.state == StepState::Current) step.what = words(result->assessment.next_action);
  step.why = Guide::tr(
      "Gravity seen from several directions tells how every cell is turned against its neighbours. No skin is "
      "connected to take more.");
  return step;
}

Step reviewStep(const SessionController& controller, const WindowActions& actions, bool captured) {
  Step step = stepOfResult(controller, Guide::tr("Review"), Guide::tr("Waits for a reconstruction."));
  const Reconstruction* result = controller.reconstruction().get();
  if (!result) return step;
  step.note = findingsText(*result);
  sayOfPoses(step, controller,
             Guide::tr("There is a result of %1.")
                 .arg(posesText(controller.session() ? controller.enabledPoses() : result->poses.size())));
  const Finding* finding = worstFinding(*result);
  if (captured) step.state = finding ? StepState::Current : StepState::Done;
  // The verdict itself stands in the banner, and the cards below say what was found.
  step.what = finding                    ? Guide::tr("Look at what was found, the worst first.")
              : result->findings.empty() ? Guide::tr("Nothing was found that does not fit.")
                                         : Guide::tr("Nothing was found that does not fit. There are notes only.");
  if (controller.session()) {
    step.why = Guide::tr(
        "A pose that does not fit can be disabled or deleted in the table of poses, and taken back with "
        "undo. A click on a finding shows the cell or link it is about.");
    step.actions = {actions.show_finding, actions.toggle_pose, actions.delete_pose, actions.recapture};
  } else {
    step.why = Guide::tr("A click on a finding shows the cell or link it is about.");
  }
  return step;
}

Step verifyStep(const SessionController& controller) {
  Step step = stepOfResult(controller, Guide::tr("Verify"), Guide::tr("Waits for a reconstruction."));
  const Reconstruction* result = controller.reconstruction().get();
  if (!result) return step;
  step.note = Guide::tr("optional");
  // Never called done: nobody has to run a check, and what a check has found stands beside it.
  sayOfPoses(step, controller, Guide::tr("There is a result to check."));
  step.what = Guide::tr("See whether the result holds.");
  step.why = Guide::tr("Each check uses something that did not go into the result.");
  return step;
}

/// "1 of 2 patches is placed".
QString placedText(const Reconstruction& result) {
  const std::size_t placed = placedPatches(result).size();
  const auto patches = static_cast<std::size_t>(
      std::ranges::count_if(result.patches, [](const PatchReconstruction& patch) { return !patch.cells.empty(); }));
  return placed == 0 ? Guide::tr("optional") : Guide::tr("%1 of %2 patches placed").arg(placed).arg(patches);
}

Step placeStep(const SessionController& controller) {
  Step step = stepOfResult(controller, Guide::tr("Place on the robot"), Guide::tr("Waits for a reconstruction."));
  const Reconstruction* result = controller.reconstruction().get();
  if (!result) return step;
  step.note = placedText(*result);
  if (!controller.session()) {
    say(step, Readiness::Blocked, Guide::tr("A calibration is open: it holds the result, not the poses."));
  } else {
    sayOfPoses(step, controller, Guide::tr("There is a result to place."));
  }
  step.what = Guide::tr("Say where on the robot each patch is.");
  step.why = Guide::tr(
      "With the robot's description and its joint angles, gravity tells which link a patch is on and how it is turned "
      "there; the link's surface, or known points, tell where. Files for robots need it.");
  return step;
}

Step exportStep(const SessionController& controller, const WindowActions& actions) {
  Step step = stepOfResult(controller, Guide::tr("Export"), Guide::tr("Waits for a reconstruction."));
  const Reconstruction* result = controller.reconstruction().get();
  if (!result) return step;
  step.actions = {actions.export_to, actions.report, actions.save_calibration};
  sayOf(step, *actions.export_to,
        hasNoPose(controller) ? Guide::tr("Without a pose, a file only holds what follows from the ports.")
                              : Guide::tr("There is a result of everything that was captured."));
  if (step.readiness == Readiness::Ready && (hasNoPose(controller) || !result->assessment.isUsable())) {
    step.readiness = Readiness::Possible;
  }
  if (controller.session()) step.actions.push_back(actions.save);
  step.what = Guide::tr("Write the placements in the form you need.");
  step.why =
      result->assessment.isUsable() ? Guide::tr("Every file is read back and compared before it is called written.")
      : result->assessment.level == VerdictLevel::NotTrusted
          ? Guide::tr(
                "The result is not to be trusted, as the line on top says: before it is exported, a question is "
                "asked.")
          : Guide::tr("It can be exported as it is, but the result is not good enough yet: see the line on top.");
  return step;
}

QString robotText(const SessionController& controller) {
  return controller.liveSession().isDemo() ? Guide::tr("The simulated robot") : Guide::tr("The robot");
}

}  // namespace

bool isDeviceLost(const SessionController& controller) {
  return fellSilent(controller) && !isOver(controller.liveSession().source());
}

QString describeAwaited(const SessionController& controller) {
  if (controller.reconstruction()) return {};
  if (controller.wasCancelled()) return Guide::tr("Working out the placements was stopped.");
  if (hasFailed(controller)) return Guide::tr("The placements could not be worked out: see the log.");
  if (controller.session()) {
    const int cells = static_cast<int>(controller.session()->neighbors().size());
    if (controller.firstPlacements()) {
      return Guide::tr("%1 cells are placed for now, and the result is being worked out…")
          .arg(QLocale().toString(cells));
    }
    return cells == 1 ? Guide::tr("The placement of the cell is being worked out…")
                      : Guide::tr("The placements of %1 cells are being worked out…").arg(QLocale().toString(cells));
  }
  if (!controller.work().activity().isEmpty()) return Guide::tr("%1…").arg(controller.work().activity());
  const LiveSource& source = controller.liveSession().source();
  if (source.isRunning() && !isOver(source)) return Guide::tr("Waiting for the skin at %1.").arg(source.address());
  return {};
}

Banner::Content describeStand(const SessionController& controller, const WindowActions& actions) {
  Banner::Content content;
  content.action = bestAction(controller, actions);
  if (isTried(controller)) {
    // The strip below says what is tried, counts down to the next try, and can give it up.
    const bool is_over = isOver(controller.liveSession().source());
    content.action = is_over ? actions.disconnect_skin : actions.connect_skin;
    const QString sentence = is_over ? Guide::tr("No skin came from %1.") : Guide::tr("Waiting for the skin at %1.");
    content.sentence = sentence.arg(controller.liveSession().source().address());
  } else if (fellSilent(controller)) {
    // For how long, and what the source does about it, says the strip below.
    content.tone = Tone::Caution;
    content.action = actions.connect_skin;
    content.sentence =
        isOver(controller.liveSession().source())
            ? Guide::tr("Nothing more will come from this skin. The poses stay; connect to a skin to take more.")
            : Guide::tr(
                  "The skin does not send any more. Check cable, power and address: once it sends again, this goes on "
                  "by itself.");
  } else if (controller.liveSession().isRobotOn()) {
    const auto next = controller.enabledPoses() + 1;
    content.sentence = Guide::tr("%1 is taking pose %2.").arg(robotText(controller)).arg(next);
  } else if (controller.wasCancelled()) {
    content.tone = Tone::Caution;
    content.sentence = controller.reconstruction()
                           ? Guide::tr("Working out the last change was stopped: the result shown is from before it.")
                           : describeAwaited(controller);
  } else if (const Reconstruction* result = controller.reconstruction().get()) {
    content.tone = toneOf(result->assessment.level);
    content.sentence = words(result->assessment.reason);
  } else if (const QString awaited = describeAwaited(controller); !awaited.isEmpty()) {
    content.tone = hasFailed(controller) ? Tone::Bad : Tone::Neutral;
    content.sentence = awaited;
  } else {
    content.sentence = Guide::tr("No skin yet: start the demo, connect to a skin, or open a session or a calibration.");
  }
  return content;
}

std::vector<Step> describeSteps(const SessionController& controller, const WindowActions& actions,
                                const SkinCheck& check) {
  std::vector<Step> steps = {connectStep(controller, actions), checkStep(controller, actions, check),
                             captureStep(controller, actions)};
  const bool captured = steps.back().state == StepState::Done;
  steps.push_back(reviewStep(controller, actions, captured));
  const bool reviewed = steps.back().state == StepState::Done;
  steps.push_back(verifyStep(controller));
  steps.push_back(placeStep(controller));
  steps.push_back(exportStep(controller, actions));
  // With everything before it done that has to be, exporting is what is left to do.
  const Reconstruction* result = controller.reconstruction().get();
  if (reviewed && result && result->assessment.isUsable()) steps.back().state = StepState::Current;
  return steps;
}

}  // namespace hexoderm
