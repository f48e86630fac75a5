// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One row per joint with its angle, its position in the joint range, and a button for each direction. The
// compact form arranges the six rows in pairs for small windows.

#include <QTimer>
#include <QVector>
#include <QWidget>

#include "robot/core/joints.h"
#include "widgets/hold/hold_to_run_button.h"

class QGridLayout;

namespace tiller {

/// Shows the position of a joint in its range, in amber near the limits.
class JointBar : public QWidget {
    Q_OBJECT

public:
    explicit JointBar(QWidget* parent = nullptr);

    /// angle  [rad]
    /// valid  if false, there is no marker
    void setAngle(double angle, bool valid);
    /// True within 15 deg of a joint limit.
    bool isNearLimit() const;

    QSize sizeHint() const override { return {94, 16}; }
    QSize minimumSizeHint() const override { return {40, 10}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Centre of the marker [device px].
    double place() const;

    double angle_ = 0;
    bool valid_ = false;
};

class JointRow : public QWidget {
    Q_OBJECT

public:
    JointRow(int joint, HoldPolicy& policy, QWidget* parent = nullptr);

    int joint() const { return joint_; }
    HoldToRunButton* minusKey() const { return minus_; }
    HoldToRunButton* plusKey() const { return plus_; }
    JointBar* bar() const { return bar_; }
    QString valueText() const { return value_; }
    void setAngle(double angle, bool moving, bool valid, bool stale);
    /// Sets the speed of the buttons, e.g. "3.6 °/s"; empty if unknown.
    void setSpeed(const QString& speed);
    QString speedText() const { return speed_; }
    /// Updates the displayed number if it has changed. setAngle() updates the marker.
    void showNumber();
    void setCompact(bool compact);
    /// Selects a full-width row with reduced height.
    void setLow(bool low);
    /// True if name and value do not overlap.
    bool isNameApart() const;
    static int heightWhen(bool compact, bool low);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QString shortName() const;
    QFont nameFont() const;
    int nameRoom() const;
    void describe();
    QRect textRect() const;
    QRect speedRect() const;

    int joint_;
    QString name_;
    QString value_;
    QString shown_;  ///< displayed value
    QString speed_;
    HoldToRunButton* minus_;
    HoldToRunButton* plus_;
    JointBar* bar_;
    bool compact_ = false;
    bool low_ = false;
    int speedWidth_ = 0;  ///< width of the speed before the bar [px]; 0: the speed is below the name or in
                          ///< the tooltip
    bool grey_ = true;
};

class JointRows : public QWidget {
    Q_OBJECT

public:
    explicit JointRows(HoldPolicy& policy, QWidget* parent = nullptr);

    const QVector<JointRow*>& rows() const { return rows_; }
    /// Updates the markers immediately, and the numbers ten times per second, because faster changes would
    /// not be legible.
    void setJoints(const JointPositions& q, bool moving, bool valid, bool stale);
    void setCompact(bool compact);
    void setLow(bool low);
    /// Total height of the rows with one or two joints per row [px].
    static int heightWhen(bool pairs, bool low);

private:
    void arrange();
    void showNumbers();

    QGridLayout* grid_;
    QVector<JointRow*> rows_;
    QTimer pace_;
    bool pending_ = false;
    bool moving_ = false;
    bool valid_ = false;
    bool stale_ = false;
    bool compact_ = false;
};

}  // namespace tiller
