// SPDX-License-Identifier: MIT
#pragma once

// Starts and ends a recording automatically. The trigger is a condition on one value of the packet, in text
// form, e.g. "actual_TCP_force_2 > 20", "robot_mode = 7", "actual_digital_input_bits:3 = 1", "runtime_state
// changes".

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "robot/core/result.h"
#include "robot/core/text.h"
#include "robot/receive/sample.h"

namespace tiller::recording {

struct RecordingTrigger {
    enum class When { Above, Below, Equal, Unequal, Changes };

    std::string column = {};  ///< e.g. "actual_TCP_force_2"
    int bit = -1;             ///< bit number; -1: the whole value
    When when = When::Above;
    double value = 0;
    double before = 0;  ///< recorded time before the trigger [s], 0 to 60
    double after = 0;   ///< recorded time after the condition has become false [s]
    int files = 0;      ///< maximum number of files; 0: one per trigger until the recording is stopped

    /// text  "COLUMN[:BIT] > VALUE", with one of > < = !=; "COLUMN changes"; or "program starts", equivalent to
    ///       "runtime_state = 2"
    /// Errors  InvalidArgument, with the expected form
    static Result<RecordingTrigger> parse(const Text& text);
};

/// Evaluates a condition for each sample.
/// Threads  one
class TriggerWatch {
public:
    enum class Verdict {
        Keep,   ///< keep the sample for the time before a trigger
        Begin,  ///< start with the stored samples and this sample
        Write,
        End,  ///< end before this sample
    };
    /// Errors   FieldUnknown: the trigger's column is not in the layout
    static Result<TriggerWatch> make(const RecordingTrigger& trigger, const receive::SampleLayout& layout);

    /// A condition that is already true for the first sample does not trigger. It must become true later.
    Verdict add(const receive::Sample& sample);

private:
    explicit TriggerWatch(RecordingTrigger trigger) : trigger_(std::move(trigger)) {}
    bool holds(double value);

    RecordingTrigger trigger_;
    std::size_t index_ = 0;
    std::optional<double> previous_;
    bool held_ = true;
    bool recording_ = false;
    std::int64_t heldUntilNs_ = 0;
};

/// Example: "force_002.mcap" for "force.mcap" and 2.
QString numberedPath(const QString& path, int number);

}  // namespace tiller::recording
