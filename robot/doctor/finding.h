// SPDX-License-Identifier: MIT
#pragma once

// The conditions that an examination checks, and its findings. A finding reports the cause and a suggested
// action.

#include <QJsonObject>
#include <QString>
#include <vector>

#include "robot/core/text.h"

namespace tiller::doctor {

using tiller::operator<<;  // makes the enumerations below printable

enum class Verdict {
    Good,
    Attention,  ///< works, but needs attention
    Bad,        ///< prevents the use of Tiller
    Skipped,    ///< not checked because another condition failed
};

/// The examined conditions. Each condition may depend on the conditions before it.
enum class Condition {
    Address,
    Host,
    RtdePort,
    PrimaryPort,
    SecondaryPort,
    RealtimePort,
    ServicePort,  ///< dashboard, or the Robot API of PolyScope X
    Protocol,     ///< the service on the RTDE port uses the RTDE protocol
    Software,
    Model,
    RemoteControl,
    Safety,
    Power,
    UpperRegisters,  ///< 24-47: used by the control program
    LowerRegisters,  ///< 0-23: used by fieldbus adapters
    DataRate,
    Privilege,
    WakeUpLatency,  ///< this PC permits disabling deep sleep of its CPUs
    ToolAndPayload,
};
inline constexpr int kConditionCount = static_cast<int>(Condition::ToolAndPayload) + 1;

struct Finding {
    Condition condition = Condition::Address;
    Verdict verdict = Verdict::Skipped;
    QString
        cause;  ///< stable name for programs and tests, e.g. "port.rtde.refused"; empty if Good or Skipped
    QString detail;  ///< observed value, e.g. "192.168.0.10", "500 of 500 packets per second"
    QString fix;     ///< suggested action in full sentences; empty if none
};

using Report = std::vector<Finding>;

/// Stable name for `--json`, e.g. "address", "port.rtde", "registers.upper".
QString conditionId(Condition condition);
/// Title for users, e.g. "Address resolves".
QString conditionTitle(Condition condition);
/// "good", "attention", "bad", "skipped".
QString verdictName(Verdict verdict);

/// Bad if any finding is Bad; otherwise Attention if any finding is Attention.
Verdict overall(const Report& report);
/// {"verdict": ..., "findings": [{"condition", "title", "verdict", "cause", "detail", "fix"}, ...]}
QJsonObject toJson(const Report& report);
/// One line per condition, followed by the suggested action in an indented line.
QString toText(const Report& report);

}  // namespace tiller::doctor
