// SPDX-License-Identifier: MIT
#pragma once

// Starts and ends a recording automatically. The trigger consists of conditions on values of the packet, in
// text form, e.g. "actual_TCP_force_2 > 20", "actual_digital_input_bits:3 = 1", "runtime_state changes",
// "norm(actual_TCP_force_0, actual_TCP_force_1) > 20 and robot_mode = 7 or program starts".

#include <QString>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/sample.h"

namespace tiller::recording {

struct TriggerCondition {
    enum class When { Above, Below, Equal, Unequal, Changes };

    /// Names of columns, e.g. "actual_TCP_force_2". If `norm` is set, the value is the square root of the sum
    /// of the squares of these columns.
    std::vector<std::string> columns{};
    bool norm = false;
    int bit = -1;  ///< bit number; -1: the whole value
    When when = When::Above;
    double value = 0;
};

struct RecordingTrigger {
    /// The trigger is active while all conditions of at least one of these lists are true.
    std::vector<std::vector<TriggerCondition>> any{};
    double before = 0;  ///< recorded time before the trigger [s], 0 to 60
    double after = 0;   ///< recorded time after the trigger has become inactive [s]
    int files = 0;      ///< maximum number of files; 0: one per trigger until the recording is stopped

    /// text  conditions, combined with "and" and "or", where "and" binds more tightly. A condition is
    ///       "COLUMN[:BIT] > VALUE" or "norm(COLUMN, ...) > VALUE", with one of > < = !=; "COLUMN changes";
    ///       or "program starts", equivalent to "runtime_state = 2"
    /// Errors  InvalidArgument, with the incorrect condition and the expected form
    static Result<RecordingTrigger> parse(const Text& text);
    /// All columns, each once.
    std::vector<std::string> columns() const;
};

/// Evaluates a trigger for each sample.
/// Threads  one
class TriggerWatch {
public:
    enum class Verdict {
        Keep,   ///< keep the sample for the time before a trigger
        Begin,  ///< start with the stored samples and this sample
        Write,
        End,  ///< end before this sample
    };
    /// Errors   FieldUnknown: a column of the trigger is not in the layout
    static Result<TriggerWatch> make(const RecordingTrigger& trigger, const receive::SampleLayout& layout);

    /// A trigger that is already active at the first sample does not start a recording. Only a later
    /// activation starts a recording.
    Verdict add(const receive::Sample& sample);
    /// The conditions that were true at the last Begin, with their values, e.g.
    /// "actual_TCP_force_2 > 20 (21.5)".
    const QString& cause() const { return cause_; }

private:
    struct Watched {
        TriggerCondition condition;
        std::vector<std::size_t> indices;  ///< indices of the columns in a sample
        std::optional<double> previous;
        double value = 0;  ///< value in the last sample
    };
    explicit TriggerWatch(const RecordingTrigger& trigger) : after_(trigger.after) {}
    static bool holds(Watched& watched, const receive::Sample& sample);
    bool isActive(const receive::Sample& sample);

    double after_;
    std::vector<std::vector<Watched>> any_;
    QString cause_;
    bool held_ = true;
    bool recording_ = false;
    std::int64_t heldUntilNs_ = 0;
};

/// Example: "force_002.mcap" for "force.mcap" and 2.
QString numberedPath(const QString& path, int number);

}  // namespace tiller::recording
