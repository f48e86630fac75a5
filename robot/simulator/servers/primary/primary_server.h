// SPDX-License-Identifier: MIT
#pragma once

// The primary and secondary services, ports 30001 and 30002, and their read-only versions 30011 and 30012.
// They send RobotState ten times a second and messages when they occur, and receive scripts. A client that
// is not reading misses packages, but it is not disconnected and does not delay other clients.
//
// A safety mode message is never sent before a RobotState with the same mode, because clients wait for the
// message and then read their newest state. A change of the safety mode therefore triggers an additional
// state. If the buffer of a client is too full for that state, the client does not get the message either.
// Source: client interface manual.

#include "robot/simulator/servers/net/server.h"
#include "robot/simulator/servers/primary/primary_messages.h"
#include "robot/simulator/servers/service/script_intake.h"

namespace tiller::simulator {

class PrimaryServer final : public Server {
public:
    /// messages  true for primary: all messages; otherwise, only the version message when a client connects
    PrimaryServer(ControllerModel& plant, bool messages, bool acceptsScripts);

    void service() override;
    using Server::publish;
    /// Sends the data of a control period: the state of the robot when due, followed by the messages. If the
    /// safety mode changes several times, only the last change is reported, because it matches the state.
    void publish(const std::vector<primary::Bytes>& messages);
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool mayWrite)
            : peer(descriptor, 64 * 1024), intake(mayWrite) {}
        Peer peer;
        ScriptIntake intake;
        std::uint64_t program = 0;  ///< program whose variables were received
        std::uint64_t knows = 0;    ///< received version of KinematicsInfo and ConfigurationData
        bool hasState = false;      ///< the state of this control period was sent to the client
    };

    void sendStates(bool evenToTheSlow);
    void sendMessages(const std::vector<primary::Bytes>& messages);
    void publishVariables();

    ControllerModel& plant_;
    std::vector<primary::Bytes> lastValues_;
    bool messages_;
    bool acceptsScripts_;
    double nextState_ = 0;  ///< [s] since the start of the simulation
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
