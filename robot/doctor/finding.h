// SPDX-License-Identifier: MIT
#pragma once

// What an examination of the way to a robot looks at, and what it found: one line per condition, each with
// its cause and what to do about it.

#include <QJsonObject>
#include <QString>
#include <vector>

#include "robot/core/text.h"

namespace tiller::doctor {

using tiller::operator<<;  // for the enumerations below

enum class Verdict {
    Good,
    Attention,  ///< works, but somebody should look
    Bad,        ///< Tiller cannot work like this
    Skipped,    ///< could not be looked at, because of another condition
};

/// In the order in which they depend on each other.
enum class Condition {
    Address,
    Host,
    RtdePort,
    PrimaryPort,
    SecondaryPort,
    RealtimePort,
    ServicePort,  ///< dashboard, or the Robot API of PolyScope X
    Protocol,     ///< what answers on the RTDE port speaks RTDE
    Software,
    Model,
    RemoteControl,
    Safety,
    Power,
    UpperRegisters,  ///< 24-47: where the control program talks
    LowerRegisters,  ///< 0-23: where fieldbus adapters talk
    DataRate,
    Privilege,
    WakeUpLatency,  ///< whether this PC may keep its processors from deep sleep
    ToolAndPayload,
};
inline constexpr int kConditionCount = static_cast<int>(Condition::ToolAndPayload) + 1;

struct Finding {
    Condition condition = Condition::Address;
    Verdict verdict = Verdict::Skipped;
    QString cause;  ///< a stable name for programs and tests: "port.rtde.refused"; empty when Good or Skipped
    QString detail;  ///< what was seen: "192.168.0.10", "500 of 500 packages a second"
    QString fix;     ///< what to do, as sentences; empty when there is nothing to do
};

using Report = std::vector<Finding>;

/// "address", "port.rtde", "registers.upper": stable, for `--json`.
QString conditionId(Condition condition);
/// "Address resolves", for people.
QString conditionTitle(Condition condition);
/// "good", "attention", "bad", "skipped".
QString verdictName(Verdict verdict);

/// Bad when any finding is; else Attention when any is.
Verdict overall(const Report& report);
/// {"verdict": ..., "findings": [{"condition", "title", "verdict", "cause", "detail", "fix"}, ...]}
QJsonObject toJson(const Report& report);
/// One line a condition, the fix indented below it.
QString toText(const Report& report);

}  // namespace tiller::doctor
