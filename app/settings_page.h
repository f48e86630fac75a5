// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings: colours, sizes, how numbers are written, the speed cap, devices, and the key of every
// command. What is chosen holds at once; there is nothing to confirm.

#include <QDialog>

#include "app/preferences.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace tiller {
class DeviceJog;
class FigureBox;
}  // namespace tiller

namespace tiller::app {

class ActionTable;

class SettingsPage : public QDialog {
    Q_OBJECT

public:
    /// theme  "light" or "dark"
    /// devices  whose switches and tuning it shows
    SettingsPage(const Preferences& preferences, const QString& theme, const ActionTable& actions,
                 DeviceJog& devices, QWidget* parent = nullptr);

    const Preferences& preferences() const { return preferences_; }
    /// Gives the command this key, as the key's editor does; an empty sequence takes its key away.
    /// Returns  false when the key is taken or reserved; hint() says by what
    bool setShortcut(const QString& id, const QKeySequence& keys);
    QString hint() const;
    /// Says who confirms that a key is held, or that nobody does.
    void setHoldNote(const QString& text);
    /// The command line has chosen monitor only: it is shown and cannot be changed here.
    void lockMonitorOnly();
    /// Says why the window cannot be built anew now.
    void refuseAnew(const QString& reason);
    /// Brings the page about recordings to the front.
    void showRecording();

protected:
    void changeEvent(QEvent* event) override;

Q_SIGNALS:
    void preferencesChanged(const tiller::app::Preferences& preferences);
    void themeChosen(const QString& theme);
    /// The window is to be built anew, in the language that was chosen.
    void windowAnewWanted();
    /// The page on which a device is tried out, in front of this one.
    void trainerWanted();
    /// The questions for a file, in front of this page.
    void exportWanted();
    void importWanted();

private:
    QWidget* buildLook(const QString& theme);
    QWidget* buildShortcuts();
    QWidget* buildDevices(DeviceJog& devices);
    QPushButton* fileKey(const QString& name, const QString& text, const QString& tip,
                         void (SettingsPage::*wanted)());
    QWidget* buildRecording();
    QComboBox* choice(const QString& name, const QString& accessible, const QStringList& texts, int current);
    void showShortcuts();
    void showCommandNames();
    void showCap();
    void showSizeNote();
    QWidget* buildLanguage();
    void showLanguageNote();
    void showCapFigure();

    Preferences preferences_;
    const ActionTable& actions_;
    QComboBox* theme_ = nullptr;
    QComboBox* density_ = nullptr;
    QComboBox* size_ = nullptr;
    QLabel* sizeNote_ = nullptr;
    QComboBox* language_ = nullptr;
    QLabel* languageNote_ = nullptr;
    QPushButton* anew_ = nullptr;
    QComboBox* lengths_ = nullptr;
    QComboBox* rotations_ = nullptr;
    QCheckBox* monitorOnly_ = nullptr;
    FigureBox* cap_ = nullptr;
    QLabel* capNote_ = nullptr;
    FigureBox* longestHold_ = nullptr;
    QLabel* holdNote_ = nullptr;
    QTableWidget* shortcuts_ = nullptr;
    QTabWidget* pages_ = nullptr;
    QWidget* recording_ = nullptr;
    QLabel* hint_ = nullptr;
};

}  // namespace tiller::app
