// SPDX-License-Identifier: MIT
#pragma once

// The primary and secondary services, ports 30001 and 30002, and their read-only versions 30011 and 30012:
// RobotState ten times a second, messages when they occur, and scripts in the other direction. A client that
// does not read misses packages; it is not disconnected and does not delay others.
//
// A safety mode message is never sent before a RobotState with the same mode, because clients wait for the
// message and then read their newest state. A change of the safety mode therefore triggers an additional
// state, and a client whose buffer is too full for that state does not get the message either. Source: client
// interface manual.

#include "robot/simulator/servers/net/server.h"
#include "robot/simulator/servers/primary/primary_messages.h"
#include "robot/simulator/servers/service/script_intake.h"

namespace tiller::simulator {

class PrimaryServer final : public Server {
public:
    /// messages  primary: all messages; otherwise only the version message at the connection
    PrimaryServer(ControllerModel& plant, bool messages, bool acceptsScripts);

    void service() override;
    using Server::publish;
    /// Sends the data of a control period: the state of the robot when due, followed by the messages. Of
    /// several changes of the safety mode only the last one is reported, which matches the state.
    void publish(const std::vector<primary::Bytes>& messages);
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool mayWrite)
            : peer(descriptor, 64 * 1024), intake(mayWrite) {}
        Peer peer;
        ScriptIntake intake;
        std::uint64_t program = 0;  ///< program whose variables it has received
        std::uint64_t knows = 0;    ///< version of the KinematicsInfo and ConfigurationData it has received
        bool hasState = false;      ///< the state of this control period was sent to it
    };

    void sendStates(bool evenToTheSlow);
    void sendMessages(const std::vector<primary::Bytes>& messages);
    void publishVariables();

    ControllerModel& plant_;
    std::vector<primary::Bytes> lastValues_;
    bool messages_;
    bool acceptsScripts_;
    double nextState_ = 0;  ///< [s] since the plant was created
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
