// SPDX-License-Identifier: MIT
#pragma once

// When a recording begins by itself, and ends: a condition on one number of the package, as people write it:
// "actual_TCP_force_2 > 20", "robot_mode = 7", "actual_digital_input_bits:3 = 1", "runtime_state changes".

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

    std::string column = {};  ///< "actual_TCP_force_2"
    int bit = -1;             ///< this bit of it alone; -1: the number itself
    When when = When::Above;
    double value = 0;
    double before = 0;  ///< recorded from before it [s], 0 to 60
    double after = 0;   ///< recorded from behind it [s]: from the moment the condition does not hold any more
    int files = 0;      ///< so many; 0: one each time, until the recording is stopped

    /// text  "COLUMN[:BIT] > VALUE", with one of > < = !=; "COLUMN changes"; or "program starts", the same as
    ///       "runtime_state = 2"
    /// Errors  InvalidArgument, saying what is expected
    static Result<RecordingTrigger> parse(const Text& text);
};

/// Watches one condition and says what is to become of each sample.
/// Threads  one
class TriggerWatch {
public:
    enum class Verdict {
        Keep,   ///< for the time before, perhaps
        Begin,  ///< with what is kept, and this one
        Write,
        End,  ///< this one is the first that does not belong to it
    };
    /// Errors   FieldUnknown: the layout has not the trigger's column
    static Result<TriggerWatch> make(const RecordingTrigger& trigger, const receive::SampleLayout& layout);

    /// A condition that holds with the first sample of all does not begin anything: it has to come true.
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

/// "force_002.mcap" of "force.mcap" and 2.
QString numberedPath(const QString& path, int number);

}  // namespace tiller::recording
