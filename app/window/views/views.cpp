#include "app/window/views/views.h"

#include "app/window/files/earlier_panel.h"
#include "app/window/guide/actions.h"
#include "app/window/guide/guide.h"
#include "app/window/guide/welcome_panel.h"
#include "app/window/log/log_view.h"
#include "app/window/toolkit/status_bar.h"
#include "widgets/capture/capture_panel.h"
#include "widgets/capture/capture_tone.h"
#include "widgets/capture/coverage_view.h"
#include "widgets/capture/instruction_voice.h"
#include "widgets/capture/live_strip.h"
#include "widgets/capture/speaker.h"
#include "widgets/capture/stillness_view.h"
#include "widgets/controls/banner.h"
#include "widgets/controls/check_list.h"
#include "widgets/controls/elided_label.h"
#include "widgets/controls/finding_card.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/step_panel.h"
#include "widgets/controls/work_notice.h"
#include "widgets/graph/graph_view.h"
#include "widgets/patch/patch_view.h"
#include "widgets/plot/plot_view.h"
#include "widgets/robot/place_panel.h"
#include "widgets/robot/robot_view.h"
#include "widgets/verify/residual_view.h"
#include "widgets/verify/verify_panel.h"

#include <QLabel>
#include <QLocale>
#include <QMenuBar>
#include <QTabBar>
#include <QVBoxLayout>

namespace hexoderm {

Views::Views(const Sources& sources, QObject* owner)
    : banner(new Banner),
      messages(new MessageBar),
      live_strip(new LiveStrip(sources.actions.disconnect_skin)),
      work_notice(new WorkNotice),
      status(new StatusBar),
      menus(new QMenuBar),
      session_name(new ElidedLabel),
      steps(new StepPanel),
      earlier(new EarlierPanel(sources.recent, sources.unsaved)),
      check_list(new CheckList),
      check_findings(new FindingCards(QStringLiteral("checkFindings"))),
      review_findings(new FindingCards(QStringLiteral("reviewFindings"))),
      finding_card(new FindingCard),
      capture_panel(new CapturePanel(
          {sources.actions.automatic, sources.actions.capture, sources.actions.skip_pose, sources.actions.turn})),
      verify_panel(new VerifyPanel(&sources.selection)),
      place_panel(new PlacePanel(&sources.selection)),
      welcome(new WelcomePanel(
          {sources.actions.demo, sources.actions.robot_demo, sources.actions.connect_skin, sources.actions.open},
          sources.recent, sources.unsaved)),
      patch(new PatchView(&sources.selection)),
      robot(new RobotView),
      graph(new GraphView(&sources.selection)),
      plot(new PlotView(&sources.selection)),
      coverage(new CoverageView),
      stillness(new StillnessView),
      tone(new CaptureTone(owner)),
      voice(new InstructionVoice(makeSystemSpeaker(QLocale(), nullptr), owner)),
      tables(owner),
      residuals(new ResidualView(&sources.selection)),
      log(new LogView(sources.log)),
      detail_tabs(new QTabBar) {
  steps->setBody(static_cast<int>(GuideStep::Connect), earlier);
  auto* checks = new QWidget;
  auto* checks_layout = new QVBoxLayout(checks);
  checks_layout->setContentsMargins(0, 0, 0, 0);
  checks_layout->addWidget(check_list);
  checks_layout->addWidget(check_findings);
  steps->setBody(static_cast<int>(GuideStep::Check), checks);
  steps->setBody(static_cast<int>(GuideStep::Review), review_findings);
  steps->setBody(static_cast<int>(GuideStep::Capture), capture_panel);
  steps->setBody(static_cast<int>(GuideStep::Place), place_panel);
}

}  // namespace hexoderm
