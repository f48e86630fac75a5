// SPDX-License-Identifier: GPL-3.0-or-later

#include "widgets/session/robot_outputs.h"

#include <cmath>

#include "robot/core/wait_until.h"
#include "robot/io/input_registers.h"
#include "widgets/session/session_backend.h"
#include "widgets/session/texts.h"

namespace tiller {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kConfirmTime{2000};
constexpr milliseconds kQuickTime{500};
constexpr milliseconds kConnectTime{3000};
constexpr std::chrono::hours kLongestPulse{1};

QString holderOf(const Result<void>& can) {
    // Not connected is no holder: setting tries to connect by itself.
    return can || can.error().code == ErrorCode::NotConnected ? QString() : can.error().context;
}

/// Outputs and what they shall be.
struct Levels {
    std::uint32_t mask;
    std::uint32_t values;
};

/// Waits until a pulse is over, or until nobody is there any more who asked for it, and lets the outputs go back.
/// begun    what came of setting them: it may have been done even where nobody heard so
/// leaving  the connection ends: what is still to be done has to be quick
/// ended    taken back, or leaving
Result<void> endOfPulse(io::Outputs& outputs, const Levels& back, const OutputOrder::Pulse& pulse,
                        const Clock& clock, const Result<void>& begun, const CancelToken& leaving,
                        const CancelToken& ended) {
    constexpr std::int64_t kMuteNs = 200 * kNsPerMs;
    if (begun) {
        const std::int64_t beganNs = clock.nowNs();
        const auto lengthNs = static_cast<std::int64_t>(pulse.seconds * static_cast<double>(kNsPerSecond));
        std::int64_t heardNs = beganNs;
        std::uint32_t heard = pulse.holds ? pulse.holds() : 0;
        waitUntil(Deadline::after(kLongestPulse, ended), [&] {
            const std::int64_t nowNs = clock.nowNs();
            if (const std::uint32_t holds = pulse.holds ? pulse.holds() : 0; holds != heard) {
                heard = holds;
                heardNs = nowNs;
            }
            return nowNs - beganNs >= lengthNs || (pulse.holds && nowNs - heardNs > kMuteNs);
        });
    } else if (begun.error().code != ErrorCode::Cancelled && begun.error().code != ErrorCode::Timeout) {
        return begun;  // it was refused
    }
    const Result<void> gone = outputs.setDigitalOutputs(
        back.mask, back.values, Deadline::after(leaving.isCancelled() ? kQuickTime : kConfirmTime));
    return begun ? gone : begun;
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

void RobotOutputs::connect() {
    if (d_.monitorOnly) {
        // Another client may need the inputs that an open connection occupies.
        d_.worker.post(&session_, [outputs = d_.link->outputs](const CancelToken&) {
            outputs->disconnect();
            return std::function<void()>();
        });
        return;
    }
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
                Q_EMIT session_.message(Severity::Warning, texts::errorText(result.error()));
            }
        });
    });
}

void RobotOutputs::forget() {
    holders_ = {};
    sliderBusy_ = false;
    sliderWanted_.reset();
    sliderLogged_.reset();
    sliderAskedNs_ = 0;
}

void RobotOutputs::setDigitalOutput(int output, bool on) {
    if (session_.refusesCommand(terminalText(ioTerminal(true, output))) || !d_.link) {
        return;
    }
    const QString done =
        tr("Output %1: %2").arg(terminalText(ioTerminal(true, output)), on ? tr("on") : tr("off"));
    const std::uint64_t generation = d_.generation;
    d_.worker.post(&session_, [this, generation, output, on, done,
                               outputs = d_.link->outputs](const CancelToken& token) {
        const Result<void> result =
            outputs->setDigitalOutput(output, on, Deadline::after(kConfirmTime, token));
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
        if (order.done) {
            order.done(Error{refused ? ErrorCode::Rejected : ErrorCode::NotConnected, what, {}});
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
    SessionWorker& worker = order.pulse ? d_.pulses : d_.worker;
    worker.post(&session_, [this, generation = d_.generation, mask, values, done, order, clock = d_.clock,
                            outputs = d_.link->outputs](const CancelToken& token) {
        Result<void> result = Error{ErrorCode::Cancelled, done, {}};
        // Taken back while it connects, it is not sent either.
        const CancelToken either(
            [token, own = order.token] { return token.isCancelled() || own.isCancelled(); });
        if (!either.isCancelled()) {
            result = outputs->setDigitalOutputs(mask, values, Deadline::after(kConfirmTime, either));
            if (order.pulse) {
                result =
                    endOfPulse(*outputs, {mask, ~values & mask}, *order.pulse, *clock, result, token, either);
            }
        }
        return std::function<void()>([this, generation, done, order, result] {
            if (result || result.error().code != ErrorCode::Cancelled) {
                report(generation, done, result);
            }
            if (order.done) {
                order.done(result);
            }
        });
    });
}

void RobotOutputs::setAnalogOutput(int output, io::AnalogDomain domain, double level) {
    if (session_.refusesCommand(terminalText(QStringLiteral("AO %1").arg(output))) || !d_.link) {
        return;
    }
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

void RobotOutputs::setRegister(const RegisterValue& value) {
    using Kind = RegisterValue::Kind;
    if (session_.refusesCommand(tr("Input register %1").arg(value.number)) || !d_.link) {
        return;
    }
    // A connection of its own, only as long as it takes: nobody else shall be kept from the register.
    io::InputRegistersOptions options;
    options.host = d_.address.host;
    options.port = static_cast<std::uint16_t>(rtde::kPort + d_.address.portOffset);
    (value.kind == Kind::Int      ? options.ints
     : value.kind == Kind::Double ? options.doubles
                                  : options.bits) = {value.number};
    const QString done = tr("Input register %1: %2").arg(value.number).arg(value.value);
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
        Q_EMIT session_.message(Severity::Info, done, Origin::Operator);
    } else {
        Q_EMIT session_.message(Severity::Error, texts::errorText(result.error()));
    }
}

void RobotOutputs::setSpeedSlider(double fraction) {
    if (session_.refusesCommand(tr("Speed slider")) || !d_.link) {
        return;
    }
    if (sliderBusy_) {
        // A slider is dragged faster than the robot confirms: only the newest wish counts.
        sliderWanted_ = fraction;
        return;
    }
    sliderBusy_ = true;
    sliderAskedNs_ = d_.clock->nowNs();
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
                Q_EMIT session_.message(Severity::Error, texts::errorText(result.error()));
            }
            if (sliderWanted_) {
                setSpeedSlider(*std::exchange(sliderWanted_, std::nullopt));
            }
        });
    });
}

// Whoever moved it; once it has come to rest, because a hand that draws it passes many places.
void RobotOutputs::reportSlider() {
    constexpr std::int64_t kRestNs = 500 * kNsPerMs;
    constexpr std::int64_t kOursNs = 3 * kNsPerSecond;  // so long a place asked for may take to be there
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
        Q_EMIT session_.message(Severity::Info, tr("Speed slider: %1 %").arg(fraction * 100, 0, 'f', 0),
                                ours ? Origin::Operator : Origin::Robot);
    }
}

}  // namespace tiller
