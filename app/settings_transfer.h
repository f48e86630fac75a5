// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings into a file and out of one, for people: asks which file, says what an import replaces before
// it does, keeps what was there, and says what is wrong with a file.

#include <QDialog>
#include <QObject>
#include <QSet>

#include "app/settings.h"

class QLabel;
class QPushButton;

namespace tiller::app {

/// What the file would replace, part by part; nothing is replaced before the key is pressed.
class ImportDialog : public QDialog {
    Q_OBJECT

public:
    /// found  of the file, or why there is nothing to import
    ImportDialog(const QString& path, const Result<SettingsBundle>& found, const SettingsBundle& present,
                 QWidget* parent = nullptr);

    /// The parts that are ticked.
    QSet<SettingsPart> chosen() const;
    /// It could not be done; the question stays.
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
    /// settings  must outlive this object
    explicit SettingsTransfer(Settings& settings, QObject* parent = nullptr);

    /// over  the window the question stands in front of
    void askToExport(QWidget* over);
    void askToImport(QWidget* over);
    /// path  gets the extension .json where it has none
    void exportTo(const QString& path);
    /// Shows what the file would replace.
    void importFrom(const QString& path, QWidget* over);

Q_SIGNALS:
    /// The settings shall hold now what is remembered of this session, as at its end.
    void upToDateWanted();
    /// Other settings are there.
    void imported();
    void message(tiller::Severity severity, const QString& text);

private:
    Settings& settings_;
};

}  // namespace tiller::app
