// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The page "Recording" of the settings: folder, file name, signals, packets per row, metadata, trigger and
// file limits. Changes take effect with the next recording.

#include <QWidget>

#include "robot/station/link/recording_choice.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;

namespace tiller {

class ChoiceBox;
class DecimalSpinBox;
class EmptyState;

namespace app {

class RecordingSettings : public QWidget {
    Q_OBJECT

public:
    explicit RecordingSettings(const RecordingChoice& choice, QWidget* parent = nullptr);

    const RecordingChoice& choice() const { return choice_; }

Q_SIGNALS:
    void chosen(const tiller::RecordingChoice& choice);

private:
    void build();
    void askForFolder();
    void takeFolder();
    void takePattern();
    void takeTrigger();
    void showTrigger();
    void editMetadata();
    void showMetadata();
    void followLimits();
    DecimalSpinBox* box(const char* name, const QString& accessibleName, double most, double value);
    void takeSignals();
    void chooseAll();
    void search(const QString& words);
    void showExample();
    void tell(const RecordingChoice& choice);

    RecordingChoice choice_;
    QLineEdit* folder_;
    QLineEdit* pattern_;
    QLabel* example_;
    DecimalSpinBox* every_;
    QLabel* rate_;
    ChoiceBox* format_;
    DecimalSpinBox* keepFree_;
    DecimalSpinBox* fileMinutes_;
    DecimalSpinBox* fileSize_;
    QPushButton* metadata_;
    ChoiceBox* asksMetadata_;
    QLineEdit* trigger_;
    QLabel* triggerNote_;
    DecimalSpinBox* before_;
    DecimalSpinBox* after_;
    QLineEdit* search_;
    QListWidget* signals_;
    EmptyState* nothing_;
};

}  // namespace app
}  // namespace tiller
