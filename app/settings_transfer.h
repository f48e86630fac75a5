// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Export and import of the settings: prompts for the file, shows which parts an import would replace, writes
// a backup, and reports errors in the file.

#include <QDialog>
#include <QObject>
#include <QSet>

#include "app/settings.h"
#include "robot/station/journal/journal.h"

class QLabel;
class QPushButton;

namespace tiller::app {

/// Shows the parts that the file would replace. Nothing is replaced without confirmation.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// found  content of the file, or the reason why the file cannot be imported
    ImportDialog(const QString& path, const Result<SettingsBundle>& found, const SettingsBundle& present,
                 QWidget* parent = nullptr);

    QSet<SettingsPart> chosen() const;
    /// Shows an error. The dialog remains open.
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
    /// settings, journal  must outlive the object
    SettingsTransfer(Settings& settings, Journal& journal, QObject* parent = nullptr);

    /// over  parent window of the dialog
    void askToExport(QWidget* over);
    void askToImport(QWidget* over);
    /// path  file path; the extension .json is added if there is no extension
    void exportTo(const QString& path);
    /// Shows the parts that the file would replace, and replaces them after confirmation.
    void importFrom(const QString& path, QWidget* over);

Q_SIGNALS:
    /// Requests that the window saves all current values, as when it closes.
    void upToDateWanted();
    /// The settings were replaced.
    void imported();

private:
    Settings& settings_;
    Journal& journal_;
};

}  // namespace tiller::app
