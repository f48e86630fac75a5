// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The one object through which the interface sees and moves a robot. It owns the backend (receiver,
// controller, I/O, the service for power and programs, recorder), turns their state into one SessionState a
// frame, and turns what the hand does into commands. Widgets hold it by reference and never talk to the
// backend themselves.

#include <QMap>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>

#include "robot/core/clock.h"
#include "robot/core/result.h"
#include "robot/script/controller_message.h"
#include "widgets/session/io_commands.h"
#include "widgets/session/robot_command.h"
#include "widgets/session/session_state.h"

namespace tiller {

namespace receive {
class Receiver;
}
namespace control {
struct Freedrive;
}
namespace dashboard {
struct ServiceReport;
}

struct RobotAddress {
    QString name;  ///< shown in the robot selector
    QString host;  ///< address or host name
    int portOffset = 0;
    bool simulated = false;
};

enum class Severity { Info, Warning, Error };
/// Whose doing a message tells of.
enum class Origin { Tiller, Operator, Robot };

/// A bounded motion: a step, or a way to a waypoint.
struct MoveRequest {
    enum class Kind { MoveJ, MoveL };
    Kind kind = Kind::MoveJ;
    JointPositions q;           ///< MoveJ: target
    Pose pose;                  ///< MoveL: target TCP pose in the base frame
    double speed = 0.25;        ///< MoveJ [rad/s], MoveL [m/s]
    double acceleration = 1.2;  ///< MoveJ [rad/s2], MoveL [m/s2]
};

class RobotSession : public QObject {
    Q_OBJECT

public:
    /// clock  drives every expiry and age in the session; the steady clock unless a test brings its own
    explicit RobotSession(const Clock& clock = SteadyClock::shared(), QObject* parent = nullptr);
    ~RobotSession() override;

    const SessionState& state() const;
    /// For plots and recorders that want every sample; null while disconnected.
    receive::Receiver* receiver() const;

    // Connection. Never blocks; the outcome comes through stateChanged and message.
    void connectTo(const RobotAddress& address);
    void disconnectFromRobot();

    // Power, recovery, programs. The outcome comes through stateChanged and message.
    void perform(RobotCommand command);
    /// Only ever on the operator's explicit word.
    void unlockProtectiveStop(const UnlockConsent& consent);
    /// name  as the controller's programs folder has it
    void loadProgram(const QString& name);
    /// Uploads the control script; needs RUNNING, and Remote control where the controller has it.
    void takeControl();
    /// Ends the control program; the robot is free for others.
    void releaseControl();

    /// fraction  0.02 ... 1; others are refused with a message
    void setSpeedSlider(double fraction);
    /// output  0-7 standard, 8-15 configurable, 16-17 tool
    void setDigitalOutput(int output, bool on);
    /// output  0 or 1; level  0 ... 1 of 4 to 20 mA or 0 to 10 V
    void setAnalogOutput(int output, io::AnalogDomain domain, double level);
    void setRegister(const RegisterValue& value);
    const OutputHolders& outputHolders() const;
    /// The operator's own names, by terminal ("DO 0", "AO 1"): messages use them.
    void setIoNames(const QMap<QString, QString>& names);

    // Motion. A motion is begun by a press and needs hold() at least every 100 ms until it is ended; whoever
    // begins it keeps the number it was given, and a number that has been stopped never moves the arm again.
    using MotionId = std::uint64_t;
    Result<MotionId> beginJog(const control::JogTarget& target);
    Result<MotionId> beginMove(const MoveRequest& request);
    /// The arm follows the hand.
    Result<MotionId> beginFreedrive(const control::Freedrive& freedrive);
    /// Keeps the motion alive; a jog may change its target on the way.
    /// Returns  false once the motion has been stopped: it needs a new press
    bool hold(MotionId motion);
    bool hold(MotionId motion, const control::JogTarget& target);
    void endMotion(MotionId motion, control::StopCause cause);
    /// Stops whatever moves, whoever began it. STOP, Esc and Space (by their causes) also stop a program that
    /// is not ours, and end the taking of control. Safe to call at any time.
    void stop(control::StopCause cause);
    const control::MotionLimits& limits() const;
    /// The fastest that TCP and elbow may get [m/s], above 0. Holds at once; another one than before stops
    /// whatever moves.
    void setSpeedCap(double metresPerSecond);

    // Recording: one CSV row per packet.
    /// Both return at once; what became of it shows in SessionState::recording and as a message.
    void startRecording(const QString& path);
    void stopRecording();

    /// Makes a new SessionState from the newest sample and tells everybody. Called by a 60 Hz timer that the
    /// session owns; tests in virtual time call it themselves.
    void refresh();
    /// Ends the link and waits for it: at the end of the program. Blocks: half a second at most, longer only
    /// where a file system does
    void shutDown();

Q_SIGNALS:
    void stateChanged(const tiller::SessionState& state);
    /// A motion ended and its stop was measured.
    void motionStopped(const tiller::control::StopMeasurement& measurement);
    /// Something the operator should be able to read again later.
    /// detail  what the text means and what to do, as sentences; may be empty
    void message(tiller::Severity severity, const QString& text,
                 tiller::Origin origin = tiller::Origin::Tiller, const QString& detail = {});
    /// What the controller itself said, whole; it comes as message too.
    void controllerMessage(const tiller::script::ControllerMessage& message);

private:
    void keepOutputsConnected();
    QString terminalText(const QString& terminal) const;
    void report(std::uint64_t generation, const QString& done, const Result<void>& result);
    void askService();
    void followService(const dashboard::ServiceReport& report);
    void leaveForLocal();
    void stopForeignProgram(control::StopCause cause);
    void followForeignStop();
    void reportChanges();
    void reportSlider();
    void reportControllerMessages();

    struct Backend;
    std::unique_ptr<Backend> d_;
};

}  // namespace tiller
