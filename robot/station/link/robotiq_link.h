// SPDX-License-Identifier: MIT
#pragma once

// The connection of the window to a Robotiq gripper. A separate thread queries the state several times a
// second and sends commands, so that an unresponsive gripper does not delay the window or an output. Values
// that the gripper does not report are shown as unknown, with the reason. Every command that is sent is
// logged with its result.
//
// The gripper is independent of the arm motion. A stop of the arm does not affect the gripper, which keeps
// its grip. A gripper command started by a held button is ended by stop() when the button is released.

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "robot/io/robotiq_client.h"
#include "robot/station/executor/serial_executor.h"
#include "robot/station/link/gripper_choice.h"

namespace tiller {

class RobotSession;

class RobotiqLink : public QObject {
    Q_OBJECT

public:
    /// session  provides the log and the check for monitor-only mode
    explicit RobotiqLink(RobotSession& session, QObject* parent = nullptr);
    ~RobotiqLink() override;

    /// Connects to the gripper of this controller, and reconnects after a lost connection. Never blocks.
    void follow(const QString& host, int port, GripperChoice::Model model);
    void leave();
    /// True during the first connection attempt.
    bool isConnecting() const { return client_ != nullptr && !state_ && failures_ == 0; }

    /// The last queried state if it is at most one second old; empty otherwise.
    std::optional<io::RobotiqState> state() const;
    /// Why the state is unknown, and the suggested action, as sentences; empty if it is known.
    QString reason() const;
    /// The fault and the suggested action; empty without a fault.
    QString faultText() const;
    /// True until the effect of a sent command has been read back.
    bool isBusy() const { return busy_; }
    /// Converts a position of the gripper to the distance between the fingers [m], and back.
    double opening(int position) const;
    int position(double opening) const;

    /// Activates the gripper: the fingers open and close once, and a held object is released.
    void activate();
    /// Moves the fingers. While a command is being executed, one more command is queued. A later command
    /// replaces the queued command.
    /// position, speed, force  0 ... 255
    /// what                    text for the log, e.g. "Gripper: close"
    /// token                   if cancelled, the command is not sent
    void move(int position, int speed, int force, const QString& what, const CancelToken& token = {});
    /// Stops the fingers and discards queued commands. Reconnects after a lost connection.
    void stop(const QString& what);

Q_SIGNALS:
    void changed();

private:
    using Call = std::function<Result<void>(io::RobotiqClient&, const Deadline&)>;
    using Look = Result<std::optional<io::RobotiqState>>;
    struct Command {
        QString what;
        Call call;
        bool activates = false;
        CancelToken token = {};
    };

    void look();
    void end();
    void take(const Look& found, bool afterCommand);
    void lose(const QString& reason);
    void note(const io::RobotiqState& now);
    void learnEnds(const io::RobotiqState& now);
    void send(const Command& command);
    void post(const Command& command);
    QString errorText(const Error& error) const;
    static QString textOf(io::RobotiqFault fault);

    RobotSession& session_;
    std::shared_ptr<io::RobotiqClient> client_;  ///< used on the worker only
    QString host_;
    int port_ = 0;
    GripperChoice::Model model_ = GripperChoice::Model::TwoF85;
    std::uint64_t generation_ = 0;  ///< replies for an older follow() are ignored
    QTimer lookTimer_;
    bool looking_ = false;
    bool busy_ = false;
    bool carriedOut_ = false;  ///< the last command was executed; the next query shows its effect
    std::optional<Command> next_;
    int failures_ = 0;  ///< number of consecutive failures
    std::optional<io::RobotiqState> state_;
    QElapsedTimer answered_;
    QString reason_;
    bool held_ = false;  ///< an object is held, according to the log
    io::RobotiqFault logged_ = io::RobotiqFault::None;
    std::optional<QElapsedTimer> activating_;  ///< time since the activation command
    // End positions of the fingers in units of the gripper. Typical values are used until the fingers have
    // reached the ends.
    static constexpr int kUsuallyOpen = 3;
    static constexpr int kUsuallyClosed = 230;
    int open_ = kUsuallyOpen;
    int closed_ = kUsuallyClosed;

    SerialExecutor worker_;  // last member, because its jobs use the members above
};

}  // namespace tiller
