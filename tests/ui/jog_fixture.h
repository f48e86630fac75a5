// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Common parts of the jog tests. The buttons of the real widgets are driven in virtual time.

#include <QApplication>
#include <QMouseEvent>
#include <QTest>

#include "tests/support/virtual_cell.h"
#include "widgets/hold/hold_to_run_button.h"
#include "widgets/jog/axis_jog.h"
#include "widgets/jog/jog_column.h"

namespace tiller::test {

/// Makes the hold-to-run buttons use the clock of the cell, so that they are refreshed in virtual time
/// instead of real time.
/// devices  for jogging without an on-screen button; may be null
inline void driveKeys(VirtualCell& cell, const QVector<HoldToRunButton*>& keys, AxisJog* devices = nullptr) {
    for (HoldToRunButton* key : keys) {
        key->guard().setClock(cell.clock);
    }
    if (devices != nullptr) {
        devices->setClock(cell.clock);
    }
    cell.everyRefresh = [keys, devices] {
        if (devices != nullptr) {
            devices->pump();
        }
        for (HoldToRunButton* key : keys) {
            if (key->guard().active()) {
                key->guard().pump();
            }
        }
    };
}

inline void sendMouse(QWidget& widget, QEvent::Type type, Qt::MouseButton button = Qt::LeftButton,
                      QPointF at = QPointF(-1, -1)) {
    if (at == QPointF(-1, -1)) {
        at = QRectF(widget.rect()).center();
    }
    const bool down = type == QEvent::MouseButtonPress || type == QEvent::MouseMove;
    QMouseEvent event(type, at, widget.mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : button,
                      down ? Qt::MouseButtons(button) : Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
}

inline void press(QWidget& key) {
    sendMouse(key, QEvent::MouseButtonPress);
}
inline void release(QWidget& key) {
    sendMouse(key, QEvent::MouseButtonRelease);
}

/// Current speed of the TCP [m/s].
inline double tcpSpeed(const VirtualCell& cell) {
    return cell.truth().tcpSpeed.linear.norm();
}

inline bool standsStill(const VirtualCell& cell) {
    const simulator::SimulatedState truth = cell.truth();
    return truth.tcpSpeed.linear.norm() < 0.001 && truth.qd.values.cwiseAbs().maxCoeff() < 0.002;
}

/// Virtual time until standstill [ms]; -1 if the arm does not stop within a second.
inline int timeToStandstill(VirtualCell& cell) {
    for (int ms = 0; ms <= 1000; ms += 2) {
        if (standsStill(cell)) {
            return ms;
        }
        cell.advanceMs(2);
    }
    return -1;
}

}  // namespace tiller::test
