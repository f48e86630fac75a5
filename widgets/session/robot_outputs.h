// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the session sets on the robot besides motion: outputs, registers, the speed slider. Whatever waits for the
// robot does so on the session's worker; the outcome comes as a message and with the next state.

#include <QCoreApplication>
#include <QMap>
#include <QString>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "robot/core/deadline.h"
#include "robot/core/result.h"
#include "widgets/session/io_commands.h"

namespace tiller {

class RobotSession;
struct SessionBackend;

/// For a command that somebody waits for, or may take back while it waits for its turn.
struct OutputOrder {
    /// For a time only, which the robot measures: then the outputs go back, whatever this program does meanwhile. Needs
    /// control.
    struct Pulse {
        double seconds = 0;
        /// Asked on the worker. Grows while the key is held: when it has not for 200 ms, the pulse ends. It also ends
        /// with the heartbeat of this program.
        std::function<std::uint32_t()> holds;
    };

    /// Cancelled: it is not sent any more. What has been sent is not undone, but for a pulse, which ends.
    CancelToken token = {};
    std::optional<Pulse> pulse = {};
    /// What came of it, in the window's thread: Cancelled when it was not sent. May be empty: the log tells anyway.
    std::function<void(const Result<void>&)> done = {};
};

class RobotOutputs {
    Q_DECLARE_TR_FUNCTIONS(RobotOutputs)

public:
    RobotOutputs(RobotSession& session, SessionBackend& backend) : session_(session), d_(backend) {}

    /// fraction  0.02 ... 1; others are refused with a message
    void setSpeedSlider(double fraction);
    /// output  0-7 standard, 8-15 configurable, 16-17 tool
    void setDigitalOutput(int output, bool on);
    /// Those of the mask at once, all or none.
    /// what  for the log, before the outputs: "Gripper: close"
    void setDigitalOutputs(std::uint32_t mask, std::uint32_t values, const QString& what,
                           const OutputOrder& order = {});
    /// Switches it on, and off after that time, which the robot measures. Refused with a message while not in control.
    void pulseDigitalOutput(int output, double seconds);
    /// Why outputs cannot be pulsed now, as a sentence; empty where they can.
    QString pulseObstacle() const;
    /// output  0 or 1; level  0 ... 1 of 4 to 20 mA or 0 to 10 V
    void setAnalogOutput(int output, io::AnalogDomain domain, double level);
    void setRegister(const RegisterValue& value);
    const OutputHolders& holders() const;
    /// The operator's own names, by terminal ("DO 0", "AO 1"): messages use them.
    void setNames(const QMap<QString, QString>& names);

    // For the session.
    /// Connects the outputs, for the first time or again.
    void connect();
    void reportSlider();
    /// Switches back outputs whose pulse the robot did not end, because its control program was ended or paused.
    void followPulses();
    /// Switches off what a pulse may have left on, also in monitor-only: the pulse was ours.
    void endPulses();
    /// The robot is gone: nothing of it is remembered but the names.
    void forget();

private:
    QString terminalText(const QString& terminal) const;
    QString changeText(int output, bool on, const std::optional<OutputOrder::Pulse>& pulse) const;
    void report(std::uint64_t generation, const QString& done, const Result<void>& result);

    RobotSession& session_;
    SessionBackend& d_;
    OutputHolders holders_;
    QMap<QString, QString> names_;
    /// Pulses that the robot times without a key that is held.
    struct RunningPulse {
        int output = 0;
        std::int64_t dueNs = 0;  ///< from then on the robot has ended it
    };
    void writeDigitalOutput(int output, bool on);

    std::vector<RunningPulse> pulses_;
    std::optional<double> sliderWanted_;  ///< newest wish while one is being carried out
    bool sliderBusy_ = false;
    std::optional<double> sliderLogged_;  ///< its place as the log knows it
    double sliderSeen_ = 0;               ///< where it was in the last frame,
    std::int64_t sliderMovedNs_ = 0;      ///< and when it got there
    std::int64_t sliderAskedNs_ = 0;      ///< when we asked for another place last; 0: never
};

}  // namespace tiller
