#pragma once

#include "app/window/session/result_files.h"
#include "hexoderm/io/export_package.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/words.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <vector>

namespace hexoderm {

/// A package while it is written, with a button to cancel it, and then the list of what was written.
class PackageDialog : public QDialog {
  Q_OBJECT

 public:
  /// Follows the package that `files` writes next. Both outlive the dialog, which belongs to `parent`.
  PackageDialog(ResultFiles& files, const QString& path, QWidget* parent = nullptr)
      : QDialog(parent), files_(files), path_(path) {
    setObjectName(QStringLiteral("packageDialog"));
    setWindowTitle(tr("Export package"));
    setPlainParagraph(sentence_);
    sentence_->setText(tr("Writing %1 …").arg(QDir::toNativeSeparators(path)));
    progress_->setAccessibleName(tr("Progress"));
    progress_->setRange(0, 0);
    list_->setHeaderLabels({tr("File"), tr("Size"), tr("What it holds")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->header()->setStretchLastSection(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    cancel_ = named(buttons->button(QDialogButtonBox::Cancel), "packageCancel");
    open_ = named(buttons->addButton(tr("Open folder"), QDialogButtonBox::ActionRole), "packageOpen");
    open_->hide();
    auto* layout = spaced(new QVBoxLayout(this), {20, 18, 20, 16}, 12);
    addWidgets(layout, {sentence_, progress_});
    layout->addWidget(list_, 1);
    layout->addWidget(buttons);
    resize(720, 420);

    connect(buttons, &QDialogButtonBox::rejected, this, &PackageDialog::reject);
    connect(open_, &QPushButton::clicked, this, [this] { emit folderWanted(path_); });
    connect(&files_, &ResultFiles::packageProgress, this, [this](const QString& name, int done, int count) {
      progress_->setRange(0, count);
      progress_->setValue(done);
      sentence_->setText(tr("Writing %1 …").arg(name));
    });
    connect(&files_, &ResultFiles::packageWritten, this, &PackageDialog::showWritten);
    connect(&files_, &ResultFiles::packageFailed, this, &PackageDialog::showFailure);
    connect(&files_, &ResultFiles::packageCancelled, this, [this] {
      is_running_ = false;
      QDialog::reject();
    });
  }

 signals:
  void folderWanted(const QString& path);

 public slots:
  /// While it is written: cancels it, and closes once nothing is left of it.
  void reject() override {
    if (!is_running_) {
      QDialog::reject();
      return;
    }
    files_.cancelPackage();
    cancel_->setEnabled(false);
    sentence_->setText(tr("Cancelling …"));
  }

 private:
  void showWritten(const QString& path, const std::vector<PackageEntry>& entries) {
    for (const PackageEntry& entry : entries) {
      QStringList holds;
      for (const Message* message : {&entry.what, &entry.frame, &entry.left_out}) {
        if (!message->empty()) holds << words(*message);
      }
      auto* item =
          new QTreeWidgetItem(list_, {QString::fromStdString(entry.name),
                                      QLocale().formattedDataSize(static_cast<qint64>(entry.size)), words(entry.what)});
      item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
      for (int column = 0; column < list_->columnCount(); ++column) {
        item->setToolTip(column, holds.join(QLatin1Char('\n')));
      }
    }
    list_->resizeColumnToContents(0);
    list_->resizeColumnToContents(1);
    open_->show();
    const QString where = QDir::toNativeSeparators(path);
    finish(isZip(path.toStdString())
               ? tr("%1 is written: %2 files. The archive was read back from the disk and compared byte for byte.")
                     .arg(where)
                     .arg(entries.size())
               : tr("%1 is written: %2 files. Each was read back from the disk and compared byte for byte.")
                     .arg(where)
                     .arg(entries.size()));
  }

  void showFailure(const QString& message) {
    list_->hide();
    finish(tr("Nothing was written. %1").arg(message));
    adjustSize();
  }

  void finish(const QString& sentence) {
    is_running_ = false;
    progress_->hide();
    sentence_->setText(sentence);
    cancel_->setText(tr("Close"));
    cancel_->setEnabled(true);
    cancel_->setFocus();
  }

  ResultFiles& files_;
  QString path_;
  bool is_running_ = true;
  QLabel* sentence_ = named(new QLabel(this), "packageSentence");
  QProgressBar* progress_ = new QProgressBar(this);
  QTreeWidget* list_ = named(new QTreeWidget(this), "packageFiles", tr("Files of the package"));
  QPushButton* cancel_;
  QPushButton* open_;
};

}  // namespace hexoderm
