// SPDX-License-Identifier: MIT
#pragma once

// Commands of the session other than motion: outputs, registers, the speed slider. Operations that wait for
// the robot run on the session's worker; the result is reported by a message and shown in the next state.

#include <QCoreApplication>
#include <QMap>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "robot/station/link/io_commands.h"

namespace tiller {

class RobotSession;
struct SessionBackend;

/// For a command whose result the caller needs, or that it may cancel while it is queued.
struct OutputOrder {
    /// A temporary change: the robot measures the time and then restores the outputs, independent of this
    /// program. Needs control.
    struct Pulse {
        double seconds = 0;
        /// Called on the worker. The value must change while the key is held: the pulse ends when it has not
        /// changed for 200 ms. It also ends when the heartbeat of this program stops.
        std::function<std::uint32_t()> holds;
    };

    /// Cancelled: the command is not sent any more. A command already sent is not undone, except that a pulse
    /// ends.
    CancelToken token = {};
    std::optional<Pulse> pulse = {};
    /// Receives the result in the GUI thread: Cancelled when the command was not sent. May be empty, because
    /// the result is logged in any case.
    std::function<void(const Result<void>&)> done = {};
};

class RobotOutputs {
    Q_DECLARE_TR_FUNCTIONS(RobotOutputs)

public:
    RobotOutputs(RobotSession& session, SessionBackend& backend) : session_(session), d_(backend) {}

    /// fraction  0.02 ... 1; other values are refused with a message
    void setSpeedSlider(double fraction);
    /// output  0-7 standard, 8-15 configurable, 16-17 tool
    void setDigitalOutput(int output, bool on);
    /// Sets all outputs of the mask at once, or none.
    /// what  prefix in the log: "Gripper: close"
    void setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const QString& what,
                           const OutputOrder& order = {});
    /// Switches the output on, and off after `seconds`, measured by the robot. Refused with a message while
    /// not in control.
    void pulseDigitalOutput(int output, double seconds);
    /// The reason why outputs cannot be pulsed now, as a sentence; empty if they can.
    QString pulseObstacle() const;
    /// output  0 or 1; level  0 ... 1 of 4 to 20 mA or 0 to 10 V
    void setAnalogOutput(int output, io::AnalogDomain domain, double level);
    void setRegister(const RegisterValue& value);
    const OutputHolders& holders() const;
    /// The operator's names by terminal ("DO 0", "AO 1"), used in messages.
    void setNames(const QMap<QString, QString>& names);

    // Used by the session.
    /// Connects the outputs, or reconnects them.
    void connect();
    void reportSlider();
    /// Restores outputs whose pulse the robot did not end because its control program was ended or paused.
    void followPulses();
    /// Switches off outputs that a pulse may have left on, even in monitor-only mode, because this program
    /// started the pulse.
    void endPulses();
    /// Clears everything known about the robot except the names.
    void forget();

private:
    QString terminalText(const QString& terminal) const;
    QString changeText(int output, bool on, const std::optional<OutputOrder::Pulse>& pulse) const;
    void report(std::uint64_t generation, const QString& done, const Result<void>& result);

    RobotSession& session_;
    SessionBackend& d_;
    OutputHolders holders_;
    QMap<QString, QString> names_;
    /// Pulses that the robot times, without a held key.
    struct RunningPulse {
        int output = 0;
        std::int64_t dueNs = 0;  ///< the robot has ended the pulse by this time
    };
    void writeDigitalOutput(int output, bool on);

    std::vector<RunningPulse> pulses_;
    std::optional<double> sliderWanted_;  ///< newest request while another one is executed
    bool sliderBusy_ = false;
    std::optional<double> sliderLogged_;  ///< last logged value
    double sliderSeen_ = 0;               ///< value in the last frame
    std::int64_t sliderMovedNs_ = 0;      ///< time of its last change
    std::int64_t sliderAskedNs_ = 0;      ///< time of our last request; 0: never
};

}  // namespace tiller
