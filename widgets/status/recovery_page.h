// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Guided recovery from a safety stop. The page shows the cause and position of the stop, the last five
// seconds before the stop, checks to confirm, and one button. For a protective stop, the button is enabled
// after five seconds if everything is confirmed. No other function of the application unlocks the robot.

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

/// A small plot of one value during the five seconds before a stop: curve, maximum, and time of the stop.
class StopPlot : public QWidget {
    Q_OBJECT

public:
    explicit StopPlot(const QString& title, QWidget* parent = nullptr);

    using Value = std::function<double(const StopRecord::Point&)>;
    /// text   formats a value with its unit
    /// least  minimum range of the scale in the unit of the value, so that noise remains small
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
    bool sent_ = false;  ///< true after the command was sent, until the robot responds
    double recordShown_ = -1;
    QStringList asked_;     ///< confirmations that are required
    double askedFor_ = -1;  ///< stop that was confirmed, as controller time [s]

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
