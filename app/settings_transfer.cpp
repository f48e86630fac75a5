// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings_transfer.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "robot/station/text/texts.h"

namespace tiller::app {
namespace {

constexpr char kPart[] = "settingsPart";

QString filter() {
    return SettingsTransfer::tr("Tiller settings (*.json)");
}

QString textOf(const Error& error) {
    // For these codes, the context is a complete sentence. VersionUnsupported refers to the file instead of
    // the robot software.
    return error.code == ErrorCode::FileCorrupt || error.code == ErrorCode::VersionUnsupported
               ? error.context
               : texts::errorText(error);
}

QString titleOf(SettingsPart part) {
    switch (part) {
        case SettingsPart::Look:
            return ImportDialog::tr("Colours, sizes and units");
        case SettingsPart::Motion:
            return ImportDialog::tr("Speed cap and maximum hold time");
        case SettingsPart::Keys:
            return ImportDialog::tr("Keyboard shortcuts");
        case SettingsPart::Devices:
            return ImportDialog::tr("Gamepad and SpaceMouse");
        case SettingsPart::Robots:
            return ImportDialog::tr("Robots and their grippers");
        case SettingsPart::IoNames:
            return ImportDialog::tr("I/O names and scales");
        case SettingsPart::Layout:
            return ImportDialog::tr("Window layout");
        case SettingsPart::Other:
            return ImportDialog::tr("Other settings");
    }
    return {};
}

/// Returns the number of entries in the list of a part; -1 if the part is not a list.
int countOf(const SettingsBundle& bundle, SettingsPart part) {
    switch (part) {
        case SettingsPart::Robots:
            return bundle.values.value(QStringLiteral("robots/size")).toInt();
        case SettingsPart::Keys:
        case SettingsPart::IoNames:
            return static_cast<int>(bundle.part(part).size());
        default:
            return -1;
    }
}

}  // namespace

ImportDialog::ImportDialog(const QString& path, const Result<SettingsBundle>& found,
                           const SettingsBundle& present, QWidget* parent)
    : QDialog(parent)
    , head_(new QLabel)
    , note_(new QLabel)
    , replace_(new QPushButton(tr("Replace")))
    , parts_(new QWidget) {
    setObjectName("importSettings");
    setWindowTitle(tr("Import settings"));
    setMinimumWidth(520);
    head_->setObjectName("importSettings.head");
    head_->setTextFormat(Qt::PlainText);
    head_->setWordWrap(true);
    note_->setObjectName("importSettings.note");
    note_->setTextFormat(Qt::PlainText);
    note_->setWordWrap(true);
    replace_->setObjectName("importSettings.replace");
    replace_->setProperty("primary", true);
    replace_->setDefault(true);
    auto* cancel = new QPushButton(found ? tr("Cancel") : tr("Close"));
    cancel->setObjectName("importSettings.cancel");
    cancel->setAutoDefault(!found);

    auto* keys = new QHBoxLayout;
    keys->addStretch(1);
    keys->addWidget(cancel);
    keys->addWidget(replace_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 20, 24, 20);
    layout->setSpacing(12);
    layout->addWidget(head_);
    layout->addWidget(parts_);
    layout->addWidget(note_);
    layout->addStretch(1);
    layout->addLayout(keys);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(replace_, &QPushButton::clicked, this, &ImportDialog::replaceRequested);

    const QString name = QFileInfo(path).fileName();
    if (!found) {
        head_->setText(tr("%1 was not imported. Nothing was changed.").arg(name));
        note_->setText(textOf(found.error()));
        note_->setProperty("role", QStringLiteral("alarm"));
        parts_->hide();
        replace_->hide();
        replace_->setDefault(false);
        cancel->setDefault(true);
        return;
    }
    head_->setText(
        found->writtenBy.isEmpty()
            ? tr("The selected settings are replaced by the settings in %1:").arg(name)
            : tr("The selected settings are replaced by the settings in %1 (written by Tiller %2):")
                  .arg(name, found->writtenBy));
    head_->setToolTip(head_->text());
    listParts(*found, present);
}

void ImportDialog::listParts(const SettingsBundle& found, const SettingsBundle& present) {
    auto* layout = new QVBoxLayout(parts_);
    layout->setContentsMargins(0, 0, 0, 0);
    bool any = false;
    for (const SettingsPart part : kSettingsParts) {
        const bool none = found.part(part).isEmpty();
        if (none && present.part(part).isEmpty()) {
            continue;
        }
        const bool same = found.hasSameValues(present, part);
        const int count = countOf(found, part);
        auto* box = new QCheckBox(same        ? tr("%1: identical").arg(titleOf(part))
                                  : none      ? tr("%1: not in the file").arg(titleOf(part))
                                  : count < 0 ? titleOf(part)
                                              : tr("%1: %2 in Tiller, %3 in the file")
                                                    .arg(titleOf(part))
                                                    .arg(countOf(present, part))
                                                    .arg(count));
        box->setObjectName(QStringLiteral("importSettings.part.%1").arg(static_cast<int>(part)));
        box->setProperty(kPart, static_cast<int>(part));
        // By default, do not delete settings that the file does not contain.
        box->setChecked(!same && !none);
        box->setEnabled(!same);
        connect(box, &QCheckBox::toggled, this, &ImportDialog::updateKey);
        layout->addWidget(box);
        any = any || !same;
    }
    note_->setProperty("role", QStringLiteral("secondary"));
    note_->setText(
        any ? tr("The replaced settings are saved to a separate file, which can be imported again.")
            : tr("All settings in the file match the current settings."));
    updateKey();
}

void ImportDialog::updateKey() {
    replace_->setEnabled(!chosen().isEmpty());
}

QSet<SettingsPart> ImportDialog::chosen() const {
    QSet<SettingsPart> parts;
    for (const QCheckBox* box : parts_->findChildren<QCheckBox*>()) {
        if (box->isChecked()) {
            parts.insert(static_cast<SettingsPart>(box->property(kPart).toInt()));
        }
    }
    return parts;
}

void ImportDialog::showFailure(const QString& text) {
    note_->setProperty("role", QStringLiteral("alarm"));
    // Set the style sheet again, so that the changed property takes effect.
    note_->setStyleSheet(note_->styleSheet());
    note_->setText(text);
}

SettingsTransfer::SettingsTransfer(Settings& settings, Journal& journal, QObject* parent)
    : QObject(parent), settings_(settings), journal_(journal) {}

void SettingsTransfer::askToExport(QWidget* over) {
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString path = QFileDialog::getSaveFileName(
        over, tr("Export settings"), documents.filePath(QStringLiteral("tiller-settings.json")), filter());
    if (!path.isEmpty()) {
        exportTo(path);
    }
}

void SettingsTransfer::askToImport(QWidget* over) {
    const QString path = QFileDialog::getOpenFileName(
        over, tr("Import settings"), QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation),
        filter());
    if (!path.isEmpty()) {
        importFrom(path, over);
    }
}

void SettingsTransfer::exportTo(const QString& path) {
    const QString full = QFileInfo(path).suffix().isEmpty() ? path + QStringLiteral(".json") : path;
    Q_EMIT upToDateWanted();
    if (const Result<void> written = writeSettingsFile(full, settings_.bundle()); !written) {
        journal_.add(Severity::Error, textOf(written.error()));
    } else {
        journal_.add(Severity::Info, tr("Settings exported to %1").arg(full));
    }
}

void SettingsTransfer::importFrom(const QString& path, QWidget* over) {
    const Result<SettingsBundle> found = readSettingsFile(path);
    if (found) {
        Q_EMIT upToDateWanted();  // save all values first, because the backup must contain them
    } else {
        journal_.add(Severity::Error, tr("%1 was not imported. Nothing was changed. %2")
                                          .arg(QFileInfo(path).fileName(), textOf(found.error())));
    }
    auto* dialog = new ImportDialog(path, found, settings_.bundle(), over);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &ImportDialog::replaceRequested, this, [this, dialog, path, found] {
        const Result<QString> backup = settings_.replace(*found, dialog->chosen());
        if (!backup) {
            dialog->showFailure(textOf(backup.error()));
            journal_.add(Severity::Error, textOf(backup.error()));
            return;
        }
        dialog->accept();
        journal_.add(
            Severity::Info,
            tr("Settings imported from %1. The previous settings were saved to %2.").arg(path, *backup));
        Q_EMIT imported();
    });
    dialog->open();
}

}  // namespace tiller::app

#include "moc_settings_transfer.cpp"
