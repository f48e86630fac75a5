// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One row a joint: its angle, where it stands in its range, and a key for each direction. In compact form the
// six rows become three rows of two, for small windows.

#include <QTimer>
#include <QVector>
#include <QWidget>

#include "robot/core/joints.h"
#include "widgets/common/hold_button.h"

class QGridLayout;

namespace tiller {

/// Where a joint stands in its range; amber near either end.
class JointBar : public QWidget {
    Q_OBJECT

public:
    explicit JointBar(QWidget* parent = nullptr);

    /// angle  [rad]; valid false: no marker
    void setAngle(double angle, bool valid);
    /// True within 15 deg of an end of the range.
    bool isNearLimit() const;

    QSize sizeHint() const override { return {94, 16}; }
    QSize minimumSizeHint() const override { return {40, 10}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Of the marker's middle [device px].
    double place() const;

    double angle_ = 0;
    bool valid_ = false;
};

class JointRow : public QWidget {
    Q_OBJECT

public:
    explicit JointRow(int joint, QWidget* parent = nullptr);

    int joint() const { return joint_; }
    HoldButton* minusKey() const { return minus_; }
    HoldButton* plusKey() const { return plus_; }
    JointBar* bar() const { return bar_; }
    QString valueText() const { return value_; }
    void setAngle(double angle, bool moving, bool valid, bool stale);
    /// At which the keys turn the joint: "3.6 °/s". Empty: not known.
    void setSpeed(const QString& speed);
    QString speedText() const { return speed_; }
    /// Paints the number, if it is another than the one painted last. Its marker needs no call: it follows the arm.
    void showNumber();
    void setCompact(bool compact);
    /// A line of full width that is less high.
    void setLow(bool low);
    /// The name ends before the value begins.
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
    QString shown_;  ///< the value painted last
    QString speed_;
    HoldButton* minus_;
    HoldButton* plus_;
    JointBar* bar_;
    bool compact_ = false;
    bool low_ = false;
    int speedWidth_ = 0;  ///< [px] before the bar; 0: the speed is elsewhere
    bool grey_ = true;
};

class JointRows : public QWidget {
    Q_OBJECT

public:
    explicit JointRows(QWidget* parent = nullptr);

    const QVector<JointRow*>& rows() const { return rows_; }
    /// The markers are painted at once, the numbers ten times a second: a person reads no faster.
    void setJoints(const JointPositions& q, bool moving, bool valid, bool stale);
    void setCompact(bool compact);
    void setLow(bool low);
    /// Of all rows, below each other or in pairs.
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
