// SPDX-License-Identifier: MIT
#pragma once

// Name, unit and number of decimal places of a signal. There is one entry per component of each output field,
// and one per bit with a separate meaning.

#include <QString>
#include <QStringList>
#include <QVector>

#include "robot/receive/field_info.h"
#include "robot/station/history/series_column.h"

namespace tiller {

struct SignalInfo {
    QString key;        ///< name as in recordings, e.g. "actual_q_0"; for a bit "robot_status_bits.1"
    QString field;      ///< RTDE field, e.g. "actual_q"; empty for other signals
    int component = 0;  ///< component of the field
    int bit = -1;       ///< bit of the component; -1: the whole value
    int axis = -1;      ///< 0 x, 1 y, 2 z; -1: no axis

    QString group;      ///< e.g. "Joints"
    QString family;     ///< group of signals shown together, e.g. "Joint currents"
    QString label;      ///< label within its group, e.g. "Base"
    QString longLabel;  ///< label outside its group, e.g. "I Base"
    QString meaning;    ///< meaning in the vendor's documentation, in English

    receive::FieldKind kind = receive::FieldKind::Number;
    receive::FieldModes modes = receive::FieldModes::None;
    QString unit{};     ///< e.g. "N"; empty if there is no unit
    int digits = 3;     ///< number of decimal places
    double step = 0.1;  ///< minimum grid spacing, so that noise is not magnified

    /// True if the signal is drawn as a lane of states instead of a curve.
    bool isState() const { return kind == receive::FieldKind::Enumeration || bit >= 0; }
    Precision precision() const {
        return kind == receive::FieldKind::Number && unit != QLatin1String("s") ? Precision::Single
                                                                                : Precision::Exact;
    }
    /// Text for the value of a state, e.g. "Running", "on", "7"; empty if there is no value.
    QString stateName(double value) const;
    /// Value with its unit or name, e.g. "12.3 N", "Running"; "–" if there is no value.
    QString valueText(double value, bool withSign = false) const;
};

void setUnit(SignalInfo& info, const QString& unit);

/// All signals of a robot, sorted by group and family.
QVector<SignalInfo> robotSignals();

}  // namespace tiller
