// SPDX-License-Identifier: MIT

#include "robot/station/link/robot_outputs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "robot/control/output_pulses.h"
#include "robot/core/wait_until.h"
#include "robot/io/input_registers.h"
#include "robot/station/link/detail/session_backend.h"
#include "robot/station/text/texts.h"

namespace tiller {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kConfirmTime{2000};
constexpr milliseconds kQuickTime{500};
constexpr milliseconds kConnectTime{3000};
/// A pulse that exceeds the requested duration by more than this time has not been ended by the robot.
constexpr milliseconds kPulseGrace{300};

QString holderOf(const Result<void>& can) {
    // A missing connection is not an obstacle, because setting an output connects automatically.
    return can || can.error().code == ErrorCode::NotConnected ? QString() : can.error().context;
}

milliseconds lengthOf(double seconds) {
    constexpr double kMsPerSecond = 1000;
    return milliseconds(std::llround(seconds * kMsPerSecond));
}

/// Outputs, and their levels during and after a pulse.
struct PulseLevels {
    std::uint32_t mask;
    std::uint32_t during;
    std::uint32_t after;
};

/// Objects shared with a pulse, so that the pulse can end safely while the connection is being closed.
struct PulseLink {
    std::shared_ptr<control::Controller> controller;
    std::shared_ptr<receive::Receiver> receiver;
    std::shared_ptr<io::Outputs> outputs;
};

/// Starts a pulse and waits until the robot ends it. Ends the pulse early when the button is released.
/// Restores the outputs over RTDE if the robot has not restored them.
/// leaving  the connection is being closed, so the remaining steps must be fast
/// ended    the order was cancelled, or `leaving`
Result<void> runHeldPulse(const PulseLink& link, const PulseLevels& levels, const OutputOrder::Pulse& pulse,
                          const Clock& clock, const CancelToken& leaving, const CancelToken& ended) {
    constexpr std::int64_t kHoldGapNs = 200 * kNsPerMs;
    control::OutputPulses pulses(*link.controller);
    const milliseconds length = lengthOf(pulse.seconds);
    const Result<void> begun = pulses.begin(levels.mask, levels.during, length, control::Holding::Held,
                                            Deadline::after(kConfirmTime, ended));
    if (!begun && begun.error().code != ErrorCode::Cancelled && begun.error().code != ErrorCode::Timeout) {
        return begun;  // rejected by the robot
    }
    bool isOver = false;
    if (begun) {
        const io::OutputFeedback feedback = io::OutputFeedback::fromReceiver(*link.receiver);
        const std::int64_t beganNs = clock.nowNs();
        const std::int64_t overdueNs = beganNs + std::chrono::nanoseconds(length + kPulseGrace).count();
        std::int64_t heldNs = beganNs;
        std::uint32_t holds = pulse.holds();
        bool isSeen = false;
        waitUntil(Deadline::after(control::kMaxPulse + kConfirmTime, ended), [&] {
            const std::int64_t nowNs = clock.nowNs();
            if (const std::uint32_t now = pulse.holds(); now != holds) {
                holds = now;
                heldNs = nowNs;
            }
            if (const auto levelsNow = feedback.newest().digitalOutputs) {
                isSeen = isSeen || (*levelsNow & levels.mask) == levels.during;
                isOver = isSeen && (*levelsNow & levels.mask) == levels.after;
            }
            return isOver || nowNs >= overdueNs || nowNs - heldNs > kHoldGapNs;
        });
    }
    if (isOver) {
        return {};
    }
    const Deadline quick = Deadline::after(leaving.isCancelled() ? kQuickTime : kConfirmTime);
    (void)pulses.end(levels.mask,
                     quick);  // fails without control or a response; the outputs are restored below
    const Result<void> back = link.outputs->setDigitalOutputs(levels.mask, levels.after, quick);
    return begun ? back : begun;
}

}  // namespace

QString ioTerminal(bool output, int channel) {
    const char* group = channel < io::kFirstConfigurable ? (output ? "DO" : "DI")
                        : channel < io::kFirstTool       ? (output ? "CO" : "CI")
                                                         : (output ? "TO" : "TI");
    const int first = channel < io::kFirstConfigurable ? 0
                      : channel < io::kFirstTool       ? io::kFirstConfigurable
                                                       : io::kFirstTool;
    return QStringLiteral("%1 %2").arg(QLatin1String(group)).arg(channel - first);
}

void RobotOutputs::setNames(const QMap<QString, QString>& names) {
    names_ = names;
}

QString RobotOutputs::terminalText(const QString& terminal) const {
    const QString name = names_.value(terminal);
    return name.isEmpty() ? terminal : tr("%1 (%2)").arg(name, terminal);
}

const OutputHolders& RobotOutputs::holders() const {
    return holders_;
}

void RobotOutputs::followControl() {
    // This time is longer than the interval between commands while the slider is dragged, and shorter than
    // the interval at which a client that could not claim the inputs retries.
    constexpr std::int64_t kUnusedNs = 2 * kNsPerSecond;
    const std::int64_t nowNs = d_.clock->nowNs();
    if (d_.state.control == ControlState::InControl && !d_.monitorOnly) {
        usedNs_ = nowNs;
        if (!std::exchange(heldByControl_, true)) {
            claim();
        }
        return;
    }
    if (heldPulses_ > 0) {
        usedNs_ = nowNs;
    }
    if (!releasing_ && nowNs - usedNs_ >= kUnusedNs && d_.link->outputs->isConnected()) {
        release();
    }
}

void RobotOutputs::release() {
    // Another client may need the inputs that this connection claims.
    releasing_ = true;
    heldByControl_ = false;
    holders_ = {};
    d_.worker.post(&session_, [this, outputs = d_.link->outputs](const CancelToken&) {
        outputs->disconnect();
        return std::function<void()>([this] {
            releasing_ = false;
            holders_ = {};
        });
    });
}

void RobotOutputs::claim() {
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, outputs = d_.link->outputs](const CancelToken& token) {
        const Result<void> result = outputs->connect(Deadline::after(kConnectTime, token));
        const OutputHolders holders{holderOf(outputs->canSetDigitalOutput(0)),
                                    holderOf(outputs->canSetDigitalOutput(io::kFirstConfigurable)),
                                    holderOf(outputs->canSetDigitalOutput(io::kFirstTool)),
                                    holderOf(outputs->canSetAnalogOutput())};
        return std::function<void()>([this, generation, result, holders] {
            if (generation != d_.generation) {
                return;
            }
            holders_ = holders;
            if (!result && result.error().code != ErrorCode::Cancelled) {
                session_.journal().add(Severity::Warning, texts::errorText(result.error()));
            }
        });
    });
}

void RobotOutputs::forget() {
    holders_ = {};
    heldByControl_ = false;
    releasing_ = false;
    heldPulses_ = 0;
    pulses_.clear();
    sliderBusy_ = false;
    sliderWanted_.reset();
    sliderLogged_.reset();
    sliderAskedNs_ = 0;
}

void RobotOutputs::setDigitalOutput(int output, bool on) {
    if (session_.refusesCommand(terminalText(ioTerminal(true, output))) || !d_.link) {
        return;
    }
    writeDigitalOutput(output, on);
}

void RobotOutputs::writeDigitalOutput(int output, bool on) {
    usedNs_ = d_.clock->nowNs();
    // A manually set output is no longer tracked as a pulse.
    std::erase_if(pulses_, [output](const RunningPulse& pulse) { return pulse.output == output; });
    const QString done =
        tr("Output %1: %2").arg(terminalText(ioTerminal(true, output)), on ? tr("on") : tr("off"));
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, output, on, done, monitors = d_.monitorOnly,
                               outputs = d_.link->outputs](const CancelToken& token) {
        const Deadline deadline = Deadline::after(kConfirmTime, token);
        Result<void> result = monitors ? outputs->connect(deadline) : Result<void>();
        if (result) {
            result = outputs->setDigitalOutput(output, on, deadline);
        }
        if (monitors) {
            outputs->disconnect();
        }
        return std::function<void()>([this, generation, done, result] { report(generation, done, result); });
    });
}

QString RobotOutputs::changeText(int output, bool on, const std::optional<OutputOrder::Pulse>& pulse) const {
    const QString terminal = terminalText(ioTerminal(true, output));
    if (!pulse) {
        return (on ? tr("%1: on") : tr("%1: off")).arg(terminal);
    }
    return (on ? tr("%1: on for %2 s") : tr("%1: off for %2 s"))
        .arg(terminal, QString::number(pulse->seconds, 'g', 6));
}

void RobotOutputs::setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const QString& what,
                                     const OutputOrder& order) {
    if (const bool refused = session_.refusesCommand(what); refused || !d_.link) {
        const Error error{refused ? ErrorCode::Rejected : ErrorCode::NotConnected, what, {}};
        if (!refused) {
            report(d_.generation, what, error);
        }
        if (order.done) {
            order.done(error);
        }
        return;
    }
    QStringList each;
    for (int output = 0; output < io::kDigitalOutputs; ++output) {
        if ((mask >> output & 1U) != 0) {
            each << changeText(output, (values >> output & 1U) != 0, order.pulse);
        }
    }
    const QString done = tr("%1 (%2)").arg(what, each.join(QStringLiteral(", ")));
    if (order.pulse && !pulseObstacle().isEmpty()) {
        const Error error{ErrorCode::NotInControl, what, {}};
        report(d_.generation, done, error);
        if (order.done) {
            order.done(error);
        }
        return;
    }
    usedNs_ = d_.clock->nowNs();
    SerialExecutor& worker = order.pulse ? d_.pulses : d_.worker;
    heldPulses_ += order.pulse ? 1 : 0;
    worker.post(&session_, [this, generation = d_.generation, mask, values, done, order, clock = d_.clock,
                            link = PulseLink{d_.link->controller, d_.link->receiver, d_.link->outputs}](
                               const CancelToken& token) {
        Result<void> result = Error{ErrorCode::Cancelled, done, {}};
        // Do not send the command if it was cancelled while connecting.
        const CancelToken either(
            [token, own = order.token] { return token.isCancelled() || own.isCancelled(); });
        if (!either.isCancelled()) {
            result = order.pulse ? runHeldPulse(link, {mask, values & mask, ~values & mask}, *order.pulse,
                                                *clock, token, either)
                                 : link.outputs->setDigitalOutputs(mask, values,
                                                                   Deadline::after(kConfirmTime, either));
        }
        return std::function<void()>([this, generation, done, order, result] {
            heldPulses_ -= order.pulse && generation == d_.generation ? 1 : 0;
            if (result || result.error().code != ErrorCode::Cancelled) {
                report(generation, done, result);
            }
            if (order.done) {
                order.done(result);
            }
        });
    });
}

QString RobotOutputs::pulseObstacle() const {
    if (d_.state.programRuns) {
        return tr(
            "The robot cannot time pulses while a program is running. Stop the program first, or switch "
            "the output on and off manually.");
    }
    return d_.link && d_.state.control == ControlState::InControl
               ? QString()
               : tr("The robot times pulses only while Tiller is in control. Take control first, or switch "
                    "the output on and off manually.");
}

void RobotOutputs::pulseDigitalOutput(int output, double seconds) {
    if (session_.refusesCommand(terminalText(ioTerminal(true, output)))) {
        return;
    }
    if (const QString obstacle = pulseObstacle(); !obstacle.isEmpty()) {
        session_.journal().add(Severity::Warning, obstacle);
        return;
    }
    const QString done = changeText(output, true, OutputOrder::Pulse{seconds, {}});
    d_.worker.post(&session_, [this, generation = d_.generation, output, seconds, done,
                               controller = d_.link->controller](const CancelToken& token) {
        const std::uint32_t bit = 1U << output;
        const Result<void> begun = control::OutputPulses(*controller)
                                       .begin(bit, bit, lengthOf(seconds), control::Holding::Free,
                                              Deadline::after(kConfirmTime, token));
        return std::function<void()>([this, generation, output, seconds, done, begun] {
            report(generation, done, begun);
            if (begun && generation == d_.generation) {
                const auto length = std::chrono::nanoseconds(lengthOf(seconds) + kPulseGrace);
                pulses_.push_back({output, d_.clock->nowNs() + length.count()});
            }
        });
    });
}

void RobotOutputs::followPulses() {
    const std::int64_t nowNs = d_.clock->nowNs();
    const auto overdue = [&](const RunningPulse& pulse) { return nowNs >= pulse.dueNs; };
    std::vector<RunningPulse> ended;
    std::copy_if(pulses_.begin(), pulses_.end(), std::back_inserter(ended), overdue);
    std::erase_if(pulses_, overdue);
    for (const RunningPulse& pulse : ended) {
        if ((d_.state.digitalOutputs >> pulse.output & 1U) != 0) {
            session_.journal().add(Severity::Warning,
                                   tr("The robot did not end the pulse on %1 because the program on the "
                                      "robot was stopped or paused. Tiller switches the output off.")
                                       .arg(terminalText(ioTerminal(true, pulse.output))));
            writeDigitalOutput(pulse.output, false);
        }
    }
}

void RobotOutputs::endPulses() {
    const std::vector<RunningPulse> running = std::exchange(pulses_, {});
    if (!d_.link) {
        return;
    }
    for (const RunningPulse& pulse : running) {
        writeDigitalOutput(pulse.output, false);
    }
}

void RobotOutputs::setAnalogOutput(int output, io::AnalogDomain domain, double level) {
    if (session_.refusesCommand(terminalText(QStringLiteral("AO %1").arg(output))) || !d_.link) {
        return;
    }
    usedNs_ = d_.clock->nowNs();
    const bool current = domain == io::AnalogDomain::Current;
    const QString done = tr("Analog output %1: %2 %3")
                             .arg(terminalText(QStringLiteral("AO %1").arg(output)))
                             .arg(current ? 4 + 16 * level : 10 * level, 0, 'f', 2)
                             .arg(current ? QStringLiteral("mA") : QStringLiteral("V"));
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, output, domain, level, done,
                               outputs = d_.link->outputs](const CancelToken& token) {
        const Result<void> result =
            outputs->setAnalogOutput(output, domain, level, Deadline::after(kConfirmTime, token));
        return std::function<void()>([this, generation, done, result] { report(generation, done, result); });
    });
}

QString RobotOutputs::registerName(const RegisterValue& value) {
    using Kind = RegisterValue::Kind;
    return (value.kind == Kind::Int      ? tr("Input int register %1")
            : value.kind == Kind::Double ? tr("Input float register %1")
                                         : tr("Input bit register %1"))
        .arg(value.number);
}

void RobotOutputs::setRegister(const RegisterValue& value) {
    using Kind = RegisterValue::Kind;
    const QString name = registerName(value);
    if (session_.refusesCommand(name) || !d_.link) {
        return;
    }
    // Use a temporary connection, so that the register is not reserved permanently.
    io::InputRegistersOptions options;
    options.host = d_.address.host;
    options.port = static_cast<std::uint16_t>(rtde::kPort + d_.address.portOffset);
    (value.kind == Kind::Int      ? options.ints
     : value.kind == Kind::Double ? options.doubles
                                  : options.bits) = {value.number};
    const QString done = QStringLiteral("%1: %2").arg(name).arg(value.value);
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, value, options, done](const CancelToken& token) {
        io::InputRegisters registers(options);
        const Deadline deadline = Deadline::after(kConnectTime, token);
        Result<void> result = registers.connect(deadline);
        if (result) {
            result = value.kind == Kind::Int
                         ? registers.setInt(value.number, static_cast<std::int32_t>(value.value), deadline)
                     : value.kind == Kind::Double
                         ? registers.setDouble(value.number, value.value, deadline)
                         : registers.setBit(value.number, value.value != 0, deadline);
        }
        registers.disconnect();
        return std::function<void()>([this, generation, done, result] { report(generation, done, result); });
    });
}

void RobotOutputs::report(std::uint64_t generation, const QString& done, const Result<void>& result) {
    if (generation != d_.generation) {
        return;
    }
    if (result) {
        session_.journal().add(Severity::Info, done, Origin::Operator);
    } else {
        session_.journal().add(Severity::Error, texts::errorText(result.error()));
    }
}

void RobotOutputs::setSpeedSlider(double fraction) {
    if (session_.refusesCommand(tr("Speed slider")) || !d_.link) {
        return;
    }
    if (sliderBusy_) {
        // The value may change faster than the robot confirms it, so only the newest value is kept.
        sliderWanted_ = fraction;
        return;
    }
    sliderBusy_ = true;
    sliderAskedNs_ = d_.clock->nowNs();
    usedNs_ = sliderAskedNs_;
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, fraction,
                               outputs = d_.link->outputs](const CancelToken& token) {
        const Result<void> result = outputs->setSpeedSlider(fraction, Deadline::after(kConfirmTime, token));
        return std::function<void()>([this, generation, result] {
            if (generation != d_.generation) {
                return;
            }
            sliderBusy_ = false;
            if (!result) {
                session_.journal().add(Severity::Error, texts::errorText(result.error()));
            }
            if (sliderWanted_) {
                setSpeedSlider(*std::exchange(sliderWanted_, std::nullopt));
            }
        });
    });
}

// Logs slider changes by any client when the slider has stopped moving.
void RobotOutputs::reportSlider() {
    constexpr std::int64_t kRestNs = 500 * kNsPerMs;
    constexpr std::int64_t kOursNs = 3 * kNsPerSecond;  // maximum time until a requested value takes effect
    constexpr double kSame = 0.005;
    const std::int64_t now = d_.clock->nowNs();
    const double fraction = d_.state.speedFraction;
    if (fraction != sliderSeen_) {
        sliderSeen_ = fraction;
        sliderMovedNs_ = now;
    }
    if (!sliderLogged_) {
        sliderLogged_ = fraction;
    } else if (std::abs(fraction - *sliderLogged_) > kSame && now - sliderMovedNs_ >= kRestNs) {
        sliderLogged_ = fraction;
        const bool ours = sliderAskedNs_ != 0 && sliderMovedNs_ - sliderAskedNs_ < kOursNs;
        session_.journal().add(Severity::Info, tr("Speed slider: %1 %").arg(fraction * 100, 0, 'f', 0),
                               ours ? Origin::Operator : Origin::Robot);
    }
}

}  // namespace tiller
