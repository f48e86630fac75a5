// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Export and import of the settings: asks for the file, shows what an import replaces before doing it, keeps a
// backup, and reports errors in a file.

#include <QDialog>
#include <QObject>
#include <QSet>

#include "app/settings.h"

class QLabel;
class QPushButton;

namespace tiller::app {

/// Shows the parts that the file would replace; nothing is replaced before confirmation.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// found  content of the file, or the reason why it cannot be imported
    ImportDialog(const QString& path, const Result<SettingsBundle>& found, const SettingsBundle& present,
                 QWidget* parent = nullptr);

    /// The selected parts.
    QSet<SettingsPart> chosen() const;
    /// Shows an error; the dialog stays open.
    void showFailure(const QString& text);

Q_SIGNALS:
    void replaceRequested();

private:
    void listParts(const SettingsBundle& found, const SettingsBundle& present);
    void updateKey();

    QLabel* head_;
    QLabel* note_;
    QPushButton* replace_;
    QWidget* parts_;
};

class SettingsTransfer : public QObject {
    Q_OBJECT

public:
    /// settings  must outlive the object
    explicit SettingsTransfer(Settings& settings, QObject* parent = nullptr);

    /// over  parent window of the dialog
    void askToExport(QWidget* over);
    void askToImport(QWidget* over);
    /// path  gets the extension .json if it has none
    void exportTo(const QString& path);
    /// Shows the parts that the file would replace, and replaces them after confirmation.
    void importFrom(const QString& path, QWidget* over);

Q_SIGNALS:
    /// Request to save all values of this session, as at its end.
    void upToDateWanted();
    /// The settings were replaced.
    void imported();
    void message(tiller::Severity severity, const QString& text);

private:
    Settings& settings_;
};

}  // namespace tiller::app
