#pragma once

#include "app/window/report/report_blocks.h"

#include <QByteArray>
#include <QStringList>
#include <vector>

namespace hexoderm {

/// The report on A4 pages. Headings stay with what follows, the rows of a table are never alone at either end of a
/// page, and its head is repeated on every page that it goes on to. To be called on a thread of Qt's.
QByteArray pdfOf(const ReportDocument& document);

/// The texts on each page, as they are laid out there; those within drawings are left out.
std::vector<QStringList> pdfTexts(const ReportDocument& document);

}  // namespace hexoderm
