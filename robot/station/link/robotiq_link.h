// SPDX-License-Identifier: MIT
#pragma once

// A Robotiq gripper as the window sees it: asked several times a second what it does, told what it shall do, in
// a thread of its own, so that a mute gripper makes neither the window nor an output wait. What it does not say
// is not known, and shown so with the reason. Every command and what came of it goes into the log.
//
// The gripper is no part of the arm's motion: a stop of the arm does not reach it, it goes on holding. What a held
// key sent it to do ends with the key, by stop().

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
    /// session  only for the log
    explicit RobotiqLink(RobotSession& session, QObject* parent = nullptr);
    ~RobotiqLink() override;

    /// Connects to the gripper of this controller, and again whenever it is lost. Never blocks.
    void follow(const QString& host, int port, GripperChoice::Model model);
    void leave();
    /// For the first time: nothing is known to be wrong yet.
    bool isConnecting() const { return client_ != nullptr && !state_ && failures_ == 0; }

    /// Nothing while it is not known.
    std::optional<io::RobotiqState> state() const;
    /// The reason why the state is unknown and the suggested action, as sentences; empty if it is known.
    QString reason() const;
    /// The fault with the suggested action; empty without a fault.
    QString faultText() const;
    /// Commands given, and not yet seen in a look.
    bool isBusy() const { return busy_; }
    /// Between the fingers [m], for a position of the gripper, and back.
    double opening(int position) const;
    int position(double opening) const;

    /// The fingers open and close once; a held object is released.
    void activate();
    /// position, speed, force  0 ... 255
    /// what  for the log: "Gripper: close"
    /// While a command is on its way the newest one waits for it, and takes the place of one that waits.
    /// token  cancelled: it is not sent any more
    void move(int position, int speed, int force, const QString& what, const CancelToken& token = {});
    /// Stops the fingers, whatever was requested before; opens a new connection if it is lost.
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
    std::uint64_t generation_ = 0;  ///< answers to an older follow() are dropped
    QTimer lookTimer_;
    bool looking_ = false;
    bool busy_ = false;
    bool carriedOut_ = false;  ///< the newest command: only a look asked for after that shows what it did
    std::optional<Command> next_;
    int failures_ = 0;  ///< one after the other
    std::optional<io::RobotiqState> state_;
    QElapsedTimer answered_;
    QString reason_;
    bool held_ = false;  ///< as shown in the log
    io::RobotiqFault logged_ = io::RobotiqFault::None;
    std::optional<QElapsedTimer> activating_;  ///< since the gripper was commanded
    // Where the fingers end, in the gripper's own positions: as usual, until they have been there.
    static constexpr int kUsuallyOpen = 3;
    static constexpr int kUsuallyClosed = 230;
    int open_ = kUsuallyOpen;
    int closed_ = kUsuallyClosed;

    SerialExecutor worker_;  // last: its jobs use what stands above
};

}  // namespace tiller
