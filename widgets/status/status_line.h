// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The status bar: recording state and file, project file, and the last message with its time.

#include <QWidget>

#include "robot/station/link/robot_session.h"

class QLabel;

namespace tiller {

class ElidedLabel;

class StatusLine : public QWidget {
    Q_OBJECT

public:
    explicit StatusLine(QWidget* parent = nullptr);
    explicit StatusLine(RobotSession& session, QWidget* parent = nullptr);

    /// text  name of the project and whether it is saved; empty: no project
    void setProjectText(const QString& text);
    /// Adds a button of fixed width at the right end and takes ownership.
    void addKey(QWidget* key);
    QString recordingText() const;
    QString messageText() const;

    static constexpr int kHeight = 36;

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);
    void showMessage(tiller::Severity severity, const QString& text);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    class Sign;
    void paintWords();
    void limitDetails();
    void followTrouble(const SessionState& state);

    Sign* sign_;
    QLabel* recording_;
    ElidedLabel* details_;
    ElidedLabel* file_;
    Sign* messageSign_;
    ElidedLabel* message_;
    RecordingState state_;
    Severity severity_ = Severity::Info;
    unsigned missing_ = 0;       ///< conditions that are not met
    unsigned missingSince_ = 0;  ///< conditions not met at some time since the message appeared
};

}  // namespace tiller
