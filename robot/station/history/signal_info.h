// SPDX-License-Identifier: MIT
#pragma once

// What a signal is called, what unit it has, and how many digits of it are worth reading: one for every number of
// every output field, and for every bit that has a meaning of its own.

#include <QString>
#include <QStringList>
#include <QVector>

#include "robot/receive/field_info.h"
#include "robot/station/history/series_column.h"

namespace tiller {

struct SignalInfo {
    QString key;    ///< "actual_q_0", as recordings name it; with the bit behind it: "robot_status_bits.1"
    QString field;  ///< "actual_q": what the robot is asked for; empty when it is not the robot's
    int component = 0;  ///< of the field
    int bit = -1;       ///< of the component; -1: all of it
    int axis = -1;      ///< 0 x, 1 y, 2 z; -1: it is along none

    QString group;      ///< "Joints"
    QString family;     ///< "Joint currents": what stands side by side with it
    QString label;      ///< "Base": among its family
    QString longLabel;  ///< "I Base": among others
    QString meaning;    ///< from the vendor's documentation, English

    receive::FieldKind kind = receive::FieldKind::Number;
    receive::FieldModes modes = receive::FieldModes::None;
    QString unit{};     ///< "N"; empty where there is none
    int digits = 3;     ///< behind the point that are worth reading
    double step = 0.1;  ///< the finest distance of two grid lines: noise is never blown up beyond it

    /// Drawn as a lane of states, not as a curve.
    bool isState() const { return kind == receive::FieldKind::Enumeration || bit >= 0; }
    Precision precision() const {
        return kind == receive::FieldKind::Number && unit != QLatin1String("s") ? Precision::Single
                                                                                : Precision::Exact;
    }
    /// What a value of a state is called: "Running", "on", "7"; empty for no value.
    QString stateName(double value) const;
    /// "12.3 N", "Running"; "–" for no value.
    QString valueText(double value, bool withSign = false) const;
};

/// Sets unit, digits and step.
void setUnit(SignalInfo& info, const QString& unit);

/// Everything a robot may tell, sorted by group and family.
QVector<SignalInfo> robotSignals();

}  // namespace tiller
