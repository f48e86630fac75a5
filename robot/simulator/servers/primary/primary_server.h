// SPDX-License-Identifier: MIT
#pragma once

// The primary and secondary services, ports 30001 and 30002, and their read-only versions 30011 and 30012.
// They send RobotState ten times a second and messages when they occur, and receive scripts. A client that is
// not reading misses packages. It is not disconnected and does not delay other clients.
//
// A safety mode message is never sent before a RobotState with the same mode, because clients wait for the
// message and then read their newest state. A change of the safety mode therefore triggers an additional
// state. If that state does not fit into the buffer of a client, the client does not get the message either.
// Source: client interface manual.

#include "robot/simulator/net/server.h"
#include "robot/simulator/plant/primary_messages.h"
#include "robot/simulator/servers/service/script_intake.h"

namespace tiller::simulator {

class PrimaryServer final : public Server {
public:
    /// messages  true (primary): all messages; false (secondary): only the version message for a new client
    PrimaryServer(ControllerModel& plant, bool messages, bool acceptsScripts);

    void service() override;
    using Server::publish;
    /// Sends the data of a control period: the state of the robot when due or when the safety mode has
    /// changed, followed by the messages. If the safety mode has changed several times, only the last change
    /// is reported, because it matches the state.
    void publish(const std::vector<primary::Bytes>& messages);
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool mayWrite)
            : peer(descriptor, 64 * 1024), intake(mayWrite) {}
        Peer peer;
        ScriptIntake intake;
        std::uint64_t program = 0;  ///< program for which the variable names were sent
        std::uint64_t knows = 0;    ///< version of KinematicsInfo and ConfigurationData that was sent
        bool hasState = false;      ///< the state of this control period was sent
    };

    void sendStates(bool evenToTheSlow);
    void sendMessages(const std::vector<primary::Bytes>& messages);
    void publishVariables();

    ControllerModel& plant_;
    std::vector<primary::Bytes> lastValues_;
    bool messages_;
    bool acceptsScripts_;
    double nextState_ = 0;  ///< due time of the next state, from Plant::elapsed() [s]
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
