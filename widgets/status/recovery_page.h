// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Guided recovery from a safety stop: cause and position of the stop, the last five seconds, checks to confirm, and
// one button. The button for a protective stop is enabled after five seconds and with all confirmations; no other
// function of the program unlocks.

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

/// A small plot of one value during five seconds before a stop: curve, maximum, and time of the stop.
class StopPlot : public QWidget {
    Q_OBJECT

public:
    explicit StopPlot(const QString& title, QWidget* parent = nullptr);

    using Value = std::function<double(const StopRecord::Point&)>;
    /// text   formats a value with its unit
    /// least  minimum range of the scale, so that noise remains small; in the unit of the value
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
    QVector<QPointF> curve_;  ///< x: time relative to the stop [s], <= 0; y: the value
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
    bool sent_ = false;  ///< the command was sent; waiting for the robot
    double recordShown_ = -1;
    QStringList asked_;     ///< required confirmations
    double askedFor_ = -1;  ///< the stop that the confirmations refer to, as time stamp of the controller [s]

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
