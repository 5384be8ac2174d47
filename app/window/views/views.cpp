#include "app/window/views/views.h"

#include "app/window/guide/guide.h"

#include <QVBoxLayout>

namespace hexoderm {

Views::Views(const Sources& sources, QObject* owner) : sources_(sources), owner_(owner) {
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
