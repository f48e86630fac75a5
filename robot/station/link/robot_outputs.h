// SPDX-License-Identifier: MIT
#pragma once

// Commands of the session other than motion: outputs, registers, the speed slider. Operations that wait for
// the robot run on the session's worker. Results are logged and appear in the next session state.

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

/// Options for a command whose result the caller needs, or which the caller may cancel while it is queued.
struct OutputOrder {
    /// A temporary change. The robot measures the time and then restores the outputs, independently of the
    /// application. Requires control.
    struct Pulse {
        double seconds = 0;
        /// Called on the worker. The returned value must change while the button is held. The pulse ends when
        /// the value has not changed for 200 ms, or when Tiller stops sending its heartbeat.
        std::function<std::uint32_t()> holds;
    };

    /// Cancels a queued command. A command already sent is not undone, but a pulse ends.
    CancelToken token = {};
    std::optional<Pulse> pulse = {};
    /// Called in the GUI thread with the result: Cancelled if the command was cancelled before it was sent;
    /// Rejected, NotConnected or NotInControl if it was refused. May be empty. Results other than Cancelled
    /// are also logged.
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
    /// what  prefix in the log, e.g. "Gripper: close"
    void setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const QString& what,
                           const OutputOrder& order = {});
    /// Switches the output on, and off after `seconds`, measured by the robot. Without control, refused with
    /// a message.
    void pulseDigitalOutput(int output, double seconds);
    /// Why outputs cannot be pulsed now, as a sentence; empty if they can.
    QString pulseObstacle() const;
    /// output  0 or 1; level  0 ... 1, for 4 to 20 mA or 0 to 10 V
    void setAnalogOutput(int output, io::AnalogDomain domain, double level);
    void setRegister(const RegisterValue& value);
    static QString registerName(const RegisterValue& value);  ///< Returns the translated name of a register.
    const OutputHolders& holders() const;
    /// Sets the operator's names by terminal ("DO 0", "AO 1"), for messages.
    void setNames(const QMap<QString, QString>& names);

    // Called by the session.
    /// Claims the inputs of the robot while in control, and releases them when they have not been used for
    /// two seconds.
    void followControl();
    void release();
    void reportSlider();
    /// Restores outputs if the robot has not ended their pulse because its control program was ended or
    /// paused.
    void followPulses();
    /// Switches off outputs that a pulse may have left on. Permitted in monitor-only mode, because this
    /// program started the pulse.
    void endPulses();
    /// Clears all data about the robot except the names.
    void forget();

private:
    QString terminalText(const QString& terminal) const;
    QString changeText(int output, bool on, const std::optional<OutputOrder::Pulse>& pulse) const;
    void report(std::uint64_t generation, const QString& done, const Result<void>& result);
    /// Claims the inputs and determines which inputs other clients have claimed.
    void claim();

    RobotSession& session_;
    SessionBackend& d_;
    OutputHolders holders_;
    QMap<QString, QString> names_;
    /// A pulse timed by the robot, without a held button.
    struct RunningPulse {
        int output = 0;
        std::int64_t dueNs = 0;  ///< time by which the robot has ended the pulse
    };
    void writeDigitalOutput(int output, bool on);

    std::vector<RunningPulse> pulses_;
    std::int64_t usedNs_ = 0;     ///< time of the last command or of the last frame in control
    bool heldByControl_ = false;  ///< the inputs have been claimed since control was taken
    bool releasing_ = false;
    int heldPulses_ = 0;  ///< running hold-to-run pulses, which restore their outputs at the end
    std::optional<double> sliderWanted_;  ///< newest requested value while an earlier request is executed
    bool sliderBusy_ = false;
    std::optional<double> sliderLogged_;  ///< last logged value
    double sliderSeen_ = 0;               ///< value in the last frame
    std::int64_t sliderMovedNs_ = 0;      ///< time of the last change of the value
    std::int64_t sliderAskedNs_ = 0;      ///< time of the last request from Tiller; 0: none
};

}  // namespace tiller
