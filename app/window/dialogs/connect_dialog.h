#pragma once

#include "app/window/files/session_paths.h"
#include "app/window/session/session_controller.h"
#include "app/window/toolkit/dialogs.h"
#include "hexoderm/base/error.h"
#include "hexoderm/device/sources/open_source.h"
#include "widgets/controls/panel_parts.h"
#include "widgets/words/words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

namespace hexoderm {

/// Asks which skin to connect to and where its poses are kept. Emits the request when it is accepted; the receiver
/// connects. Remembers the last choice.
class ConnectDialog : public QDialog {
  Q_OBJECT

 public:
  /// `folder`: where new sessions go unless another is chosen. `open_session`: name of the session that poses can be
  /// added to; empty if there is none.
  ConnectDialog(const QString& folder, const QString& open_session, QWidget* parent = nullptr) : QDialog(parent) {
    setObjectName(QStringLiteral("connectDialog"));
    setWindowTitle(tr("Connect to a skin"));
    setModal(true);
    auto* title = styledAs(new QLabel(tr("Where is the skin?"), this), "headline");
    for (const Kind& kind : kKinds) kind_->addItem(tr(kind.name));
    address_->setEditable(true);
    constexpr int kLongestPath = 4096;
    address_->lineEdit()->setMaxLength(kLongestPath);
    address_->setInsertPolicy(QComboBox::NoInsert);
    address_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    hint_->setWordWrap(true);
    continue_->setText(tr("Add the poses to the session that is open, %1").arg(open_session));
    continue_->setChecked(!open_session.isEmpty());
    continue_->setVisible(!open_session.isEmpty());
    path_->setText(newSessionPath(folder));
    note_->setWordWrap(true);
    note_->setMinimumHeight(3 * fontMetrics().lineSpacing());
    note_->setTextFormat(Qt::PlainText);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    connect_ = addPrimaryButton(this, buttons, tr("Connect"), "connectButton");

    auto* layout = spaced(new QGridLayout(this), {20, 18, 20, 16});
    layout->setHorizontalSpacing(14);
    layout->setVerticalSpacing(10);
    constexpr Qt::Alignment kCaption = Qt::AlignRight | Qt::AlignVCenter;
    layout->addWidget(title, 0, 0, 1, 3);
    layout->addWidget(labelFor(kind_, tr("&Kind")), 1, 0, kCaption);
    layout->addWidget(kind_, 1, 1);
    layout->addWidget(labelFor(address_, tr("&Address")), 2, 0, kCaption);
    layout->addWidget(address_, 2, 1);
    layout->addWidget(browse_recording_, 2, 2);
    layout->addWidget(hint_, 3, 1, 1, 2);
    layout->addWidget(continue_, 4, 1, 1, 2);
    layout->addWidget(labelFor(path_, tr("K&eep in")), 5, 0, kCaption);
    layout->addWidget(path_, 5, 1);
    layout->addWidget(browse_path_, 5, 2);
    layout->addWidget(note_, 6, 1, 1, 2);
    layout->addWidget(buttons, 7, 0, 1, 3);
    layout->setColumnStretch(1, 1);
    // In proportion to the text.
    constexpr int kUsualText_px = 17;
    resize(QSize(660, 330) * std::max(1.0, fontMetrics().height() / static_cast<double>(kUsualText_px)));

    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ConnectDialog::chooseKind);
    connect(address_, &QComboBox::editTextChanged, this, &ConnectDialog::check);
    connect(browse_recording_, &QPushButton::clicked, this, &ConnectDialog::chooseRecording);
    connect(continue_, &QCheckBox::toggled, this, &ConnectDialog::check);
    connect(path_, &QLineEdit::textChanged, this, &ConnectDialog::check);
    connect(browse_path_, &QPushButton::clicked, this, &ConnectDialog::choosePath);
    const int last = QSettings().value(kKindSetting, 0).toInt();
    kind_->setCurrentIndex(last >= 0 && last < kind_->count() ? last : 0);
    chooseKind();
    address_->setFocus();
  }

  [[nodiscard]] ConnectRequest request() const {
    ConnectRequest request;
    const QString prefix = QLatin1String(kindAt(kind_->currentIndex()).prefix);
    const QString text = address_->currentText().trimmed();
    request.address = text.startsWith(prefix) ? text : prefix + text;
    request.path = QDir::fromNativeSeparators(path_->text().trimmed());
    request.continue_session = !continue_->isHidden() && continue_->isChecked();
    return request;
  }

 signals:
  void connectRequested(const hexoderm::ConnectRequest& request);

 public slots:
  void accept() override {
    check();
    if (!connect_->isEnabled()) return;
    QSettings settings;
    settings.setValue(kKindSetting, kind_->currentIndex());
    settings.setValue(addressSetting(kindAt(kind_->currentIndex())), address_->currentText().trimmed());
    emit connectRequested(request());
    QDialog::accept();
  }

 private:
  static inline const QString kExtension = QStringLiteral(".hexo");
  static inline const QString kKindSetting = QStringLiteral("connect/kind");
  /// The kinds of sources that make sense in a window. Standard input is for scripts.
  struct Kind {
    const char* prefix;
    const char* name;
    const char* first;    ///< the address at first
    const char* example;  ///< behind the prefix
    const char* hint;
  };

  static constexpr std::array<Kind, 5> kKinds = {{
      {"sim:", QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Simulated skin"), "x17",
       "x17?surface=cylinder:r=0.05&seed=2",
       QT_TRANSLATE_NOOP(
           "hexoderm::ConnectDialog",
           "x17, ring8 or sheet:10x10, also with options: x17?seed=1&speed=2; or robot, an arm with two patches. "
           "Its readings are made up.")},
      {"tcp://", QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Network, TCP"), "", "192.168.0.7:7700",
       QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Name or number of the device, a colon and its port.")},
      {"udp://", QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Network, UDP"), "", "192.168.0.7:7700",
       QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Name or number of the device, a colon and its port.")},
      {"serial:", QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Serial port"), "", "/dev/ttyUSB0?baud=115200",
       QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "The ports that are there now are in the list.")},
      {"replay:", QT_TRANSLATE_NOOP("hexoderm::ConnectDialog", "Recording"), "", "/home/me/arm.skinrec",
       QT_TRANSLATE_NOOP("hexoderm::ConnectDialog",
                         "A file that hexoderm-cli capture --record has made; ?speed=4 behind it plays it faster.")},
  }};

  static const Kind& kindAt(int row) { return kKinds[static_cast<std::size_t>(row)]; }
  static bool isRecording(const Kind& kind) { return QLatin1String(kind.prefix) == QLatin1String("replay:"); }
  static bool isSerial(const Kind& kind) { return QLatin1String(kind.prefix) == QLatin1String("serial:"); }
  static QString addressSetting(const Kind& kind) {
    return QStringLiteral("connect/address_%1")
        .arg(QString::fromLatin1(kind.prefix).remove(QLatin1Char(':')).remove('/'));
  }

  /// Ports by the names that stay the same first.
  static QStringList serialPorts() {
    QStringList ports;
    for (const QString& name : QDir(QStringLiteral("/dev/serial/by-id")).entryList(QDir::Files | QDir::System)) {
      ports << QStringLiteral("/dev/serial/by-id/") + name;
    }
    const QDir devices(QStringLiteral("/dev"));
    for (const QString& name :
         devices.entryList({QStringLiteral("ttyUSB*"), QStringLiteral("ttyACM*")}, QDir::Files | QDir::System)) {
      ports << devices.filePath(name);
    }
    return ports;
  }

  /// The fault of an address, in core's words; empty if there is none.
  static QString problemWithAddress(const QString& address) {
    try {
      checkSkinAddress(address.toStdString());
    } catch (const Error& error) {
      return words(error);
    }
    return {};
  }

  /// The file of a recording's address; empty for other kinds.
  static QString recordingOf(const Kind& kind, const QString& address) {
    if (!isRecording(kind)) return {};
    return address.section(QStringLiteral("?speed="), 0, 0).section(QLatin1String(kind.prefix), -1);
  }

  void chooseKind() {
    const Kind& kind = kindAt(kind_->currentIndex());
    const QStringList ports = isSerial(kind) ? serialPorts() : QStringList();
    {
      const QSignalBlocker quiet(address_);
      address_->clear();
      address_->addItems(ports);
      QString address = QSettings().value(addressSetting(kind), QLatin1String(kind.first)).toString();
      if (address.isEmpty() && !ports.isEmpty()) address = ports.front();
      address_->setEditText(address);
      address_->lineEdit()->setPlaceholderText(tr("for example %1").arg(QLatin1String(kind.example)));
      address_->lineEdit()->selectAll();
    }
    browse_recording_->setVisible(isRecording(kind));
    hint_->setText(isSerial(kind) && ports.isEmpty()
                       ? tr("No serial port is there now; plug the device in, or type the name of its port.")
                       : tr(kind.hint));
    check();
  }

  void chooseRecording() {
    askForFile(this, "", tr("Recording to play"), QFileInfo(path_->text()).absolutePath(), {}, this,
               [this](const QString& path) { address_->setEditText(path); });
  }

  void choosePath() {
    auto* dialog = new FileDialog(this, tr("Keep the poses in"), QFileInfo(path_->text()).absolutePath());
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    // Nothing is ever replaced; this dialog says so.
    dialog->setOption(QFileDialog::DontConfirmOverwrite);
    dialog->setNameFilter(tr("Sessions (*.hexo)"));
    dialog->setDefaultSuffix(kExtension.mid(1));
    dialog->selectFile(QFileInfo(path_->text()).fileName());
    connect(dialog, &QFileDialog::fileSelected, path_, &QLineEdit::setText);
    openInTurns(dialog);
  }

  void check() {
    const Kind& kind = kindAt(kind_->currentIndex());
    const bool continues = request().continue_session;
    path_->setEnabled(!continues);
    browse_path_->setEnabled(!continues);
    QString problem;
    if (address_->currentText().trimmed().isEmpty()) {
      problem = tr("Type an address, for example %1.").arg(QLatin1String(kind.example));
    } else if (const QString file = recordingOf(kind, address_->currentText().trimmed());
               !file.isEmpty() && !QFileInfo(file).isFile()) {
      problem = tr("There is no file %1.").arg(QDir::toNativeSeparators(file));
    } else {
      problem = problemWithAddress(request().address);
    }
    if (problem.isEmpty() && !continues) problem = problemWithPath();
    connect_->setEnabled(problem.isEmpty());
    connect_->setToolTip(problem);
    note_->setText(!problem.isEmpty() ? problem
                   : continues        ? QString()
                                      : tr("Every pose is written to this file before it is called captured."));
  }

  [[nodiscard]] QString problemWithPath() const {
    const QFileInfo target(request().path);
    if (path_->text().trimmed().isEmpty()) return tr("Say which file the poses should be kept in.");
    if (!target.fileName().endsWith(kExtension)) return tr("The file's name should end in %1.").arg(kExtension);
    if (!target.absoluteDir().exists()) {
      return tr("There is no folder %1.").arg(QDir::toNativeSeparators(target.absolutePath()));
    }
    if (target.exists()) return tr("There is a file of this name, and a capture never replaces one.");
    if (!QFileInfo(target.absolutePath()).isWritable()) {
      return tr("Nothing can be written in the folder %1.").arg(QDir::toNativeSeparators(target.absolutePath()));
    }
    return {};
  }

  QComboBox* kind_ = named(new QComboBox(this), "connectKind", tr("Kind of connection"));
  QComboBox* address_ = named(new QComboBox(this), "connectAddress", tr("Address"));
  QPushButton* browse_recording_ = new QPushButton(tr("Browse…"), this);
  QLabel* hint_ = styledAs(new QLabel(this), "muted");
  QCheckBox* continue_ = named(new QCheckBox(this), "connectContinue");
  QLineEdit* path_ = named(new QLineEdit(this), "connectPath", tr("File that the poses are kept in"));
  QPushButton* browse_path_ = new QPushButton(tr("Browse…"), this);
  QLabel* note_ = named(new QLabel(this), "connectNote");
  QPushButton* connect_;
};

}  // namespace hexoderm
