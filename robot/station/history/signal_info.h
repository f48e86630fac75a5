// SPDX-License-Identifier: MIT
#pragma once

// Name, unit and number of significant digits of a signal: one entry per component of every output field, and
// per bit with a separate meaning.

#include <QString>
#include <QStringList>
#include <QVector>

#include "robot/receive/field_info.h"
#include "robot/station/history/series_column.h"

namespace tiller {

struct SignalInfo {
    QString key;        ///< "actual_q_0", as in recordings; with the bit appended: "robot_status_bits.1"
    QString field;      ///< "actual_q": the field requested from the robot; empty for other signals
    int component = 0;  ///< of the field
    int bit = -1;       ///< of the component; -1: the whole value
    int axis = -1;      ///< 0 x, 1 y, 2 z; -1: no axis

    QString group;      ///< "Joints"
    QString family;     ///< "Joint currents": group of signals shown together
    QString label;      ///< "Base": name within its group
    QString longLabel;  ///< "I Base": name among signals of other groups
    QString meaning;    ///< from the vendor's documentation, English

    receive::FieldKind kind = receive::FieldKind::Number;
    receive::FieldModes modes = receive::FieldModes::None;
    QString unit{};     ///< "N"; empty if none
    int digits = 3;     ///< significant decimal places
    double step = 0.1;  ///< minimum distance of two grid lines, so that noise is not magnified

    /// Drawn as a lane of states, not as a curve.
    bool isState() const { return kind == receive::FieldKind::Enumeration || bit >= 0; }
    Precision precision() const {
        return kind == receive::FieldKind::Number && unit != QLatin1String("s") ? Precision::Single
                                                                                : Precision::Exact;
    }
    /// Text for the value of a state: "Running", "on", "7"; empty for no value.
    QString stateName(double value) const;
    /// "12.3 N", "Running"; "–" for no value.
    QString valueText(double value, bool withSign = false) const;
};

/// Sets unit, digits and step.
void setUnit(SignalInfo& info, const QString& unit);

/// All signals of a robot, sorted by group and family.
QVector<SignalInfo> robotSignals();

}  // namespace tiller
