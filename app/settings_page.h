// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The settings: theme, sizes, number format, speed cap, devices, and shortcuts. Changes take effect
// immediately.

#include <QDialog>

#include "app/preferences.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace tiller {
class DeviceJog;
class DecimalSpinBox;
}  // namespace tiller

namespace tiller::app {

class ActionTable;
struct PreferenceRow;

class SettingsPage : public QDialog {
    Q_OBJECT

public:
    /// theme    "light" or "dark"
    /// devices  the devices to be configured
    SettingsPage(const Preferences& preferences, const QString& theme, const ActionTable& actions,
                 DeviceJog& devices, QWidget* parent = nullptr);

    const Preferences& preferences() const { return preferences_; }
    /// Assigns this shortcut to the command. The shortcut editor calls the same function. An empty sequence
    /// removes the shortcut.
    /// Returns  false if the key is in use or reserved; hint() then contains the reason
    bool setShortcut(const QString& id, const QKeySequence& keys);
    QString hint() const;
    /// Shows the description of the key-state check.
    void setHoldNote(const QString& text);
    /// Shows that the command line has enabled "monitor only", so that it cannot be changed.
    void lockMonitorOnly();
    /// Shows why the window cannot be reopened in the selected language at the moment.
    void refuseNewWindow(const QString& reason);
    void showRecording();

protected:
    void changeEvent(QEvent* event) override;

Q_SIGNALS:
    void preferencesChanged(const tiller::app::Preferences& preferences);
    void themeChosen(const QString& theme);
    /// The user wants to reopen the window in the selected language.
    void newWindowWanted();
    /// The user wants to open the device test page on top of this page.
    void trainerWanted();
    /// The user wants to open the export dialog on top of this page.
    void exportWanted();
    void importWanted();

private:
    QWidget* buildLook(const QString& theme);
    void addRow(QFormLayout& form, const PreferenceRow& row);
    QWidget* fieldOf(const PreferenceRow& row);
    void addTheme(QFormLayout& form, const QString& theme);
    void addSize(QFormLayout& form);
    void addCap(QFormLayout& form);
    void change(const PreferenceRow& row, const QVariant& value);
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
    void showCapValue();

    Preferences preferences_;
    const ActionTable& actions_;
    QComboBox* theme_ = nullptr;
    QComboBox* size_ = nullptr;
    QLabel* sizeNote_ = nullptr;
    QComboBox* language_ = nullptr;
    QLabel* languageNote_ = nullptr;
    QPushButton* reopen_ = nullptr;
    QCheckBox* monitorOnly_ = nullptr;
    DecimalSpinBox* cap_ = nullptr;
    QLabel* capNote_ = nullptr;
    QLabel* holdNote_ = nullptr;
    QTableWidget* shortcuts_ = nullptr;
    QTabWidget* pages_ = nullptr;
    QWidget* recording_ = nullptr;
    QLabel* hint_ = nullptr;
};

}  // namespace tiller::app
