#pragma once

#include "app/window/session/result_files.h"
#include "widgets/words/words.h"

#include <QCoreApplication>
#include <QListWidget>
#include <QSettings>

namespace hexoderm {

/// The files that a package can hold, to be ticked: reports, Hexoderm's own file, and every export format. Remembers
/// what was ticked, from one dialog to the next.
class PackageList : public QListWidget {
  Q_OBJECT

 public:
  explicit PackageList(QWidget* parent = nullptr) : QListWidget(parent) {
    setObjectName(QStringLiteral("packageFormats"));
    setAccessibleName(tr("Files of the package"));
    add({kPdf, tr("Report, PDF"), tr("verdict, pictures, checks and tables, to be sent or printed")});
    add({kHtml, tr("Report, HTML"), tr("the same for a browser, in one file")});
    add({kOwn, tr("Calibration"), tr("everything that is known, in Hexoderm's own file")});
    for (const ExportFormatDescription& format : exportFormats()) {
      add({packagedName(format), packagedName(format).toUpper(), words(format.summary)});
    }
    setCurrentRow(0);
  }

  /// The ticked ones; path and options are left empty.
  [[nodiscard]] PackageRequest request() const {
    const QStringList names = ticked();
    PackageRequest request;
    request.report_pdf = names.contains(kPdf);
    request.report_html = names.contains(kHtml);
    request.calibration = names.contains(kOwn);
    for (const ExportFormatDescription& format : exportFormats()) {
      if (names.contains(packagedName(format))) request.formats.push_back(format.format);
    }
    return request;
  }

  /// For the next dialog.
  void keepChoice() const { QSettings().setValue(kTicked, ticked()); }

 private:
  static inline const QString kTicked = QStringLiteral("export/package");
  static inline const QString kPdf = QStringLiteral("report-pdf");
  static inline const QString kHtml = QStringLiteral("report-html");
  static inline const QString kOwn = QStringLiteral("calibration");
  static QString packagedName(const ExportFormatDescription& format) {
    return QString::fromUtf8(format.name.data(), static_cast<int>(format.name.size()));
  }

  struct Row {
    QString name;  ///< in the settings
    QString text;
    QString what;
  };
  void add(const Row& row) {
    const QStringList before =
        QSettings().value(kTicked, QStringList{kPdf, kOwn, QStringLiteral("urdf")}).toStringList();
    auto* item = new QListWidgetItem(row.text, this);
    item->setData(Qt::UserRole, row.name);
    item->setToolTip(row.what);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(before.contains(row.name) ? Qt::Checked : Qt::Unchecked);
  }

  [[nodiscard]] QStringList ticked() const {
    QStringList names;
    for (int k = 0; k < count(); ++k) {
      if (item(k)->checkState() == Qt::Checked) names << item(k)->data(Qt::UserRole).toString();
    }
    return names;
  }
};

/// What each file of a package holds, in which frame, and what it can't hold, as rich text.
inline QString packageText(const std::vector<PackageEntry>& entries) {
  QString html;
  for (const PackageEntry& entry : entries) {
    html += QStringLiteral("<p style=\"margin-top:0;margin-bottom:10px\"><b>%1</b><br/>%2")
                .arg(QString::fromStdString(entry.name).toHtmlEscaped(), words(entry.what).toHtmlEscaped());
    for (const Message* message : {&entry.frame, &entry.not_carried, &entry.left_out}) {
      if (!message->empty()) html += QStringLiteral("<br/>") + words(*message).toHtmlEscaped();
    }
    html += QStringLiteral("</p>");
  }
  return html;
}

}  // namespace hexoderm
