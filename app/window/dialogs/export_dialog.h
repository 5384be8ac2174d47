#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/session/result_files.h"
#include "app/window/session/session_controller.h"
#include "app/window/toolkit/dialogs.h"
#include "hexoderm/base/error.h"
#include "hexoderm/solve/result/patch_placements.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/words.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QTabBar>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hexoderm {

inline QString toQString(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<int>(text.size()));
}

/// The files that a package can hold, to be ticked: reports, Hexoderm's own file, and every export format. Remembers
/// what was ticked, from one dialog to the next.
class PackageList : public QListWidget {
  Q_OBJECT

 public:
  explicit PackageList(QWidget* parent = nullptr) : QListWidget(parent) {
    setObjectName(QStringLiteral("packageFormats"));
    setAccessibleName(tr("Files of the package"));
    add(kPdf, tr("Report, PDF"), tr("verdict, pictures, checks and tables, to be sent or printed"));
    add(kHtml, tr("Report, HTML"), tr("the same for a browser, in one file"));
    add(kOwn, tr("Calibration"), tr("everything that is known, in Hexoderm's own file"));
    for (const ExportFormatDescription& format : exportFormats()) {
      add(packagedName(format), packagedName(format).toUpper(), words(format.summary));
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
  static QString packagedName(const ExportFormatDescription& format) { return toQString(format.name); }

  /// `name`: in the settings.
  void add(const QString& name, const QString& text, const QString& what) {
    const QStringList before =
        QSettings().value(kTicked, QStringList{kPdf, kOwn, QStringLiteral("urdf")}).toStringList();
    auto* item = new QListWidgetItem(text, this);
    item->setData(Qt::UserRole, name);
    item->setToolTip(what);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(before.contains(name) ? Qt::Checked : Qt::Unchecked);
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

/// Asks for contents, place and format of an export, and of several patches for one where the format has one frame.
/// Or, on its second tab, for the files of a package, with what each will hold. Emits the request when it is accepted;
/// the receiver writes. Remembers the tab and the choice of a package.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// `reconstruction`: what would be exported now, null if there is nothing; `suggestion`: path without an extension.
  ExportDialog(std::shared_ptr<const Reconstruction> reconstruction, const QString& suggestion,
               QWidget* parent = nullptr)
      : QDialog(parent), reconstruction_(std::move(reconstruction)) {
    setObjectName(QStringLiteral("exportDialog"));
    if (reconstruction_) {
      options_.placements = placedPatches(*reconstruction_);
      if (reconstruction_->robot) options_.robot_urdf = toPath(QString::fromStdString(reconstruction_->robot->urdf));
    }
    setWindowTitle(tr("Export the calibration"));
    setModal(true);
    kinds_->addTab(tr("One &file"));
    kinds_->addTab(tr("&Package"));
    kinds_->setExpanding(false);
    kinds_->setDrawBase(false);
    auto* browse = named(new QPushButton(tr("Browse…"), this), "exportBrowse");
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    export_ = addPrimaryButton(this, buttons, tr("Export"), "exportButton");
    summary_->setWordWrap(true);
    note_->setWordWrap(true);
    note_->setMinimumHeight(2 * fontMetrics().lineSpacing());

    auto* layout = spaced(new QGridLayout(this), {20, 18, 20, 16});
    layout->setHorizontalSpacing(18);
    layout->setVerticalSpacing(12);
    addWidgets(lists_, {makeFormatList(), package_});
    lists_->setFixedWidth(kListWidth);
    summary_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    addWidgets(contents_, {summary_, preview_});
    layout->addWidget(kinds_, 0, 0, 1, 3);
    layout->addWidget(lists_, 1, 0, 2, 1);
    layout->addWidget(contents_, 1, 1, 1, 2);
    auto* choices = new QVBoxLayout;
    addWidgets(choices, {makePatchRow(), makeOptions()});
    layout->addLayout(choices, 2, 1, 1, 2);
    container_->addItems({tr("Folder"), tr("Zip archive")});
    auto* where = new QHBoxLayout;
    where->addStretch(1);
    where->addWidget(new QLabel(tr("Write to"), this));
    where->addWidget(container_);
    layout->addLayout(where, 3, 0);
    layout->addWidget(path_, 3, 1);
    layout->addWidget(browse, 3, 2);
    layout->addWidget(note_, 4, 1, 1, 2);
    layout->addWidget(buttons, 5, 0, 1, 3);
    layout->setColumnStretch(1, 1);
    layout->setRowStretch(1, 1);
    resize(780, 520);
    path_->setText(suggestion + kCalibrationExtension);
    extension_ = kCalibrationExtension;
    connect(browse, &QPushButton::clicked, this, &ExportDialog::choosePath);
    formats_->setCurrentRow(0);
    connectFields();
    container_->setCurrentIndex(QSettings().value(kIsZip, false).toBool() ? 1 : 0);
    kinds_->setCurrentIndex(QSettings().value(kIsPackage, false).toBool() ? 1 : 0);
    chooseKind();
    path_->setFocus();
    path_->selectAll();
  }

  [[nodiscard]] ExportRequest request() const {
    ExportRequest request{std::nullopt, path(), options_};
    if (const ExportFormatDescription* chosen = format()) request.format = chosen->format;
    request.options.all_patches = patch_->count() > 0 && !patch_->currentData().isValid();
    request.options.patch = chosenPatch();
    return request;
  }

  [[nodiscard]] PackageRequest packageRequest() const {
    PackageRequest asked = package_->request();
    asked.path = path();
    asked.options = options_;
    asked.options.patch = chosenPatch();
    return asked;
  }

 signals:
  void exportRequested(const hexoderm::ExportRequest& request);
  void packageRequested(const hexoderm::PackageRequest& request);

 public slots:
  void accept() override {
    check();
    if (!export_->isEnabled()) return;
    QSettings().setValue(kIsPackage, isPackage());
    if (isPackage()) {
      QSettings().setValue(kIsZip, container_->currentIndex() == 1);
      package_->keepChoice();
      emit packageRequested(packageRequest());
    } else {
      emit exportRequested(request());
    }
    QDialog::accept();
  }

 private:
  /// In the list of patches, besides their origin cells.
  static constexpr uint kAllPlaced = 0;
  static constexpr int kListWidth = 180;
  static inline const QString kCalibrationExtension = QStringLiteral(".calibration.json");
  static inline const QString kZip = QStringLiteral(".zip");
  static inline const QString kIsPackage = QStringLiteral("export/is_package");
  static inline const QString kIsZip = QStringLiteral("export/is_zip");
  [[nodiscard]] bool isPackage() const { return kinds_->currentIndex() == 1; }
  [[nodiscard]] QString path() const { return QDir::fromNativeSeparators(path_->text().trimmed()); }
  /// Of the one file; null: the calibration, row 0 of the list. The others follow exportFormats().
  [[nodiscard]] const ExportFormatDescription* format() const {
    const int row = formats_->currentRow();
    return row > 0 ? &exportFormats()[static_cast<std::size_t>(row) - 1] : nullptr;
  }
  [[nodiscard]] std::optional<CellId> chosenPatch() const {
    const uint origin = patch_->currentData().toUInt();
    return origin != kAllPlaced ? std::optional(CellId(origin)) : std::nullopt;
  }

  QWidget* makeFormatList() {
    formats_->addItem(tr("Calibration"));
    for (const ExportFormatDescription& format : exportFormats()) formats_->addItem(toQString(format.name).toUpper());
    return formats_;
  }

  QWidget* makeOptions() {
    auto* page = new QWidget;
    auto* form = spaced(new QFormLayout(page), {0, 0, 0, 0});
    for (const ExportOptionDescription& option : exportOptions()) {
      auto* label = new QLabel(words(option.label));
      QWidget* field = makeOptionField(option);
      form->addRow(label, field);
      option_rows_.push_back({label, field});
    }
    return page;
  }

  /// The field of one option, which writes into options_.
  QWidget* makeOptionField(const ExportOptionDescription& option) {
    const QString value = QString::fromStdString(option.get(options_));
    const QString object_name = QStringLiteral("export-") + toQString(option.name);
    const auto* const described = &option;  // lives as long as the program
    if (option.kind == ExportOptionDescription::Kind::Choice) {
      auto* box = new QComboBox;
      setNames(box, object_name, words(option.label));
      box->setToolTip(words(option.help));
      for (const ExportOptionDescription::Choice& choice : option.choices) {
        box->addItem(words(choice.label), toQString(choice.value));
      }
      box->setCurrentIndex(box->findData(value));
      connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, box, described] {
        described->set(options_, box->currentData().toString().toStdString());
        check();
      });
      return box;
    }
    auto* edit = new QLineEdit(value);
    setNames(edit, object_name, words(option.label));
    edit->setToolTip(words(option.help));
    connect(edit, &QLineEdit::textChanged, this, [this, described](const QString& text) {
      described->set(options_, text.trimmed().toStdString());
      check();
    });
    return option.kind == ExportOptionDescription::Kind::File ? makeFileField(option, edit) : edit;
  }

  QWidget* makeFileField(const ExportOptionDescription& option, QLineEdit* edit) {
    auto* field = new QWidget;
    auto* row = spaced(new QHBoxLayout(field), {0, 0, 0, 0});
    auto* browse = new QPushButton(tr("Browse…"));
    browse->setObjectName(edit->objectName() + QStringLiteral("-browse"));
    row->addWidget(edit, 1);
    row->addWidget(browse);
    connect(browse, &QPushButton::clicked, this, [this, edit, title = words(option.label)] {
      askForFile(this, "", title, QFileInfo(edit->text()).absolutePath(), {}, edit,
                 [edit](const QString& path) { edit->setText(path); });
    });
    return field;
  }

  void showOptions() {
    const std::vector<ExportFormat> chosen = chosenFormats();
    for (std::size_t k = 0; k < option_rows_.size(); ++k) {
      const bool shown = std::ranges::any_of(exportOptions()[k].formats, [&chosen](ExportFormat format) {
        return std::ranges::find(chosen, format) != chosen.end();
      });
      option_rows_[k].label->setVisible(shown);
      option_rows_[k].field->setVisible(shown);
    }
  }

  QWidget* makePatchRow() {
    patch_->setToolTip(tr("How the patches lie to each other is not known, so that a file with one frame holds one"));
    patch_row_ = new QWidget;
    auto* form = spaced(new QFormLayout(patch_row_), {0, 0, 0, 0});
    form->addRow(tr("Patch"), patch_);
    return patch_row_;
  }

  /// The patches that can be chosen in the present format.
  void offerPatches() {
    const ExportFormatDescription* one = isPackage() ? nullptr : format();
    const QSignalBlocker blocker(patch_);
    const QVariant before = patch_->currentData();
    patch_->clear();
    std::vector<const PatchReconstruction*> patches;
    if (!chosenFormats().empty() && reconstruction_) {
      for (const PatchReconstruction& patch : reconstruction_->patches) {
        if (!patch.cells.empty()) patches.push_back(&patch);
      }
      const PatchReconstruction* largest = largestPatch(*reconstruction_);
      std::stable_partition(patches.begin(), patches.end(), [largest](const auto* patch) { return patch == largest; });
    }
    const auto holds = [one](PatchesInFile patches_in_file) { return one && one->patches == patches_in_file; };
    const bool has_links = holds(PatchesInFile::OnLinks) || holds(PatchesInFile::OnALink);
    if (has_links && !options_.placements.empty()) patch_->addItem(tr("All that are placed on the robot"), kAllPlaced);
    if (isPackage()) patch_->addItem(tr("As many as each format can hold"), kAllPlaced);
    const auto offerAll = [this] { patch_->addItem(tr("All, each in its own frame")); };
    if (holds(PatchesInFile::All)) offerAll();
    for (const PatchReconstruction* patch : patches) {
      patch_->addItem(patch->cells.size() == 1
                          ? tr("Cell %1 alone").arg(patch->origin.value())
                          : tr("Patch of cell %1, %2 cells").arg(patch->origin.value()).arg(patch->cells.size()),
                      patch->origin.value());
    }
    if (holds(PatchesInFile::AllIfAsked)) offerAll();
    if (isPackage()) patch_->setCurrentIndex(std::max(0, patch_->findData(before)));
    patch_row_->setVisible(patches.size() > 1);
  }

  void chooseFormat() {
    const ExportFormatDescription* one = format();
    summary_->setText(
        one ? QStringList({words(one->summary), words(one->not_carried)}).join(QLatin1Char('\n')).trimmed()
            : tr("Hexoderm's own file: everything that is known, to be opened again, compared and exported "
                 "from later."));
    showOptions();
    offerPatches();
    // The name stays, the extension follows the format.
    QString name = path_->text();
    if (!extension_.isEmpty() && name.endsWith(extension_)) name.chop(extension_.size());
    extension_ = extension();
    if (!name.isEmpty() && !name.endsWith(extension_)) name += extension_;
    path_->setText(name);
    check();
  }

  void choosePath() {
    const bool folder = extension().isEmpty();
    auto* dialog = new FileDialog(this, tr("Write to"), QFileInfo(path_->text()).absolutePath());
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setFileMode(QFileDialog::AnyFile);
    // Replacing is said, and confirmed, in this dialog.
    dialog->setOption(QFileDialog::DontConfirmOverwrite);
    if (!folder) dialog->setNameFilter(QStringLiteral("*%1").arg(extension()));
    dialog->selectFile(QFileInfo(path_->text()).fileName());
    connect(dialog, &QFileDialog::fileSelected, path_, &QLineEdit::setText);
    openInTurns(dialog);
  }

  void check() {
    if (isPackage() && extension().isEmpty() && path_->text().endsWith(kZip)) {
      // A name that was typed says it, too.
      const QSignalBlocker blocker(container_);
      container_->setCurrentIndex(1);
      extension_ = kZip;
    }
    const QFileInfo target(path());
    QString remark;
    const QString refused = describeChoice(remark);
    QString problem = problemWith(target);
    if (problem.isEmpty()) problem = refused;
    const bool is_folder = extension().isEmpty();
    const bool is_there =
        is_folder && !isPackage() ? QDir(target.filePath()).exists(QStringLiteral("cells.csv")) : target.exists();
    const bool replaces = problem.isEmpty() && is_there;
    if (replaces) {
      const QString what = !is_folder    ? tr("There is a file of this name; it will be replaced.")
                           : isPackage() ? tr("There is a folder of this name; files of the same names in it are "
                                              "replaced.")
                                         : tr("The tables in this folder will be replaced.");
      remark = QStringList({what, remark}).join(QLatin1Char('\n')).trimmed();
    }
    export_->setText(replaces ? tr("Replace") : tr("Export"));
    export_->setEnabled(problem.isEmpty());
    export_->setToolTip(problem);
    note_->setText(problem.isEmpty() ? remark : problem);
  }

  [[nodiscard]] QString problemWith(const QFileInfo& target) const {
    const QString name = QDir::toNativeSeparators(target.filePath());
    if (isPackage() && packageRequest().isEmpty()) return tr("Tick the files that the package is to hold.");
    if (path().isEmpty()) {
      return isPackage() ? tr("Say where the package should go.") : tr("Say where the file should go.");
    }
    if (!target.absoluteDir().exists()) {
      return tr("There is no folder %1.").arg(QDir::toNativeSeparators(target.absolutePath()));
    }
    if (!extension().isEmpty() && target.isDir()) return tr("%1 is a folder; give the file a name.").arg(name);
    if (isPackage() && extension().isEmpty() && target.exists() && !target.isDir()) {
      return tr("%1 is a file; give the folder another name.").arg(name);
    }
    return {};
  }

  /// What the files of the package will hold, or what the one file will not; returns why there can be none.
  QString describeChoice(QString& left_out) {
    try {
      if (isPackage()) {
        const PackageRequest asked = packageRequest();
        preview_->setHtml(asked.isEmpty() || !reconstruction_
                              ? QString()
                              : packageText(previewPackage(*reconstruction_, packageContent(asked), asked.options)));
      } else if (const ExportRequest asked = request(); asked.format) {
        asked.options.validateFor(*asked.format);
        if (reconstruction_) {
          left_out = words(leftOutText(patchesLeftOut(*reconstruction_, *asked.format, asked.options)));
        }
      }
      return {};
    } catch (const InvalidArgument& error) {
      preview_->clear();
      return words(error);
    }
  }

  void connectFields() {
    connect(kinds_, &QTabBar::currentChanged, this, &ExportDialog::chooseKind);
    connect(container_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportDialog::chooseFormat);
    connect(formats_, &QListWidget::currentRowChanged, this, &ExportDialog::chooseFormat);
    connect(package_, &QListWidget::itemChanged, this, &ExportDialog::chooseFormat);
    connect(patch_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportDialog::check);
    connect(path_, &QLineEdit::textChanged, this, &ExportDialog::check);
  }

  /// One file, or a package.
  void chooseKind() {
    lists_->setCurrentIndex(kinds_->currentIndex());
    contents_->setCurrentIndex(kinds_->currentIndex());
    container_->setVisible(isPackage());
    chooseFormat();
  }

  /// The formats whose options matter.
  [[nodiscard]] std::vector<ExportFormat> chosenFormats() const {
    if (isPackage()) return package_->request().formats;
    return format() ? std::vector{format()->format} : std::vector<ExportFormat>{};
  }

  [[nodiscard]] QString extension() const {
    if (isPackage()) return container_->currentIndex() == 1 ? kZip : QString();
    return format() ? toQString(format()->extension) : kCalibrationExtension;
  }

  std::shared_ptr<const Reconstruction> reconstruction_;
  QTabBar* kinds_ = named(new QTabBar(this), "exportKinds", tr("One file or several"));
  QStackedWidget* lists_ = new QStackedWidget(this);
  QStackedWidget* contents_ = new QStackedWidget(this);
  QListWidget* formats_ = named(new QListWidget(this), "exportFormats", tr("Format"));
  PackageList* package_ = new PackageList(this);
  QLabel* summary_ = styledAs(new QLabel(this), "muted");
  QTextBrowser* preview_ = named(new QTextBrowser(this), "packagePreview", tr("What each file will hold"));
  QComboBox* container_ = named(new QComboBox(this), "exportContainer", tr("Folder or archive"));
  QLineEdit* path_ = named(new QLineEdit(this), "exportPath", tr("File to write"));
  ExportOptions options_;
  /// The row of each of exportOptions().
  struct OptionRow {
    QLabel* label;
    QWidget* field;
  };
  std::vector<OptionRow> option_rows_;
  QWidget* patch_row_ = nullptr;
  QComboBox* patch_ = named(new QComboBox(this), "exportPatch", tr("Patch"));
  QLabel* note_ = named(new QLabel(this), "exportNote");
  QPushButton* export_;
  QString extension_;
};

}  // namespace hexoderm
