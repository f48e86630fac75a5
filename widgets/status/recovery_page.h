// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The way back from a stop of the safety system, one step at a time: what stopped the arm and where, the last
// five seconds, what to look at, and one key. The key of a protective stop works once the five seconds are
// over and everything is ticked; nothing else in the program unlocks.

#include <QDialog>
#include <array>
#include <functional>

#include "robot/station/capture/stop_record.h"
#include "robot/station/link/recovery_guide.h"
#include "robot/station/link/robot_session.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace tiller {

/// Five seconds of one value before a stop, small: the curve, its largest value, and where the stop was.
class StopPlot : public QWidget {
    Q_OBJECT

public:
    explicit StopPlot(const QString& title, QWidget* parent = nullptr);

    using Value = std::function<double(const StopRecord::Point&)>;
    /// text   shows a value with its unit
    /// least  the scale goes at least so far, so that noise looks like noise; in the value's unit
    void show(const StopRecord& record, const Value& value, const std::function<QString(double)>& text,
              double least);
    const QVector<QPointF>& curve() const { return curve_; }
    QString peakText() const { return peak_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {240, 50}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString title_;
    QString peak_;
    double least_ = 0;
    QVector<QPointF> curve_;  ///< x: [s] before the stop, <= 0; y: the value
};

class RecoveryPage : public QDialog {
    Q_OBJECT

public:
    RecoveryPage(RobotSession& session, const StopRecorder& stops, QWidget* parent = nullptr);

    const RecoveryGuide& guide() const { return guide_; }

public Q_SLOTS:
    void applyState(const tiller::SessionState& state);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showRecord();
    void showChecks();
    void showKey();
    void takeStep();

    RobotSession& session_;
    const StopRecorder& stops_;
    RecoveryGuide guide_;
    bool sent_ = false;  ///< the step was taken; the key waits for the robot to follow
    double recordShown_ = -1;
    QStringList asked_;     ///< what is to be ticked
    double askedFor_ = -1;  ///< the stop it is asked for, by the controller's time stamp [s]

    QLabel* title_;
    QLabel* what_;
    QLabel* where_;
    QLabel* reports_;
    std::array<StopPlot*, 3> plots_{};
    QVBoxLayout* checkLayout_;
    QVector<QCheckBox*> checks_;
    QLabel* waiting_;
    QPushButton* key_ = nullptr;
};

}  // namespace tiller
