// SPDX-License-Identifier: MIT
#pragma once

// The primary and secondary services, ports 30001 and 30002, with their read-only twins 30011 and 30012:
// RobotState ten times a second, messages when they happen, scripts the other way. A client that does not
// read misses packages; it is never dropped for that and never makes the others wait.
//
// A safety mode message never comes before a RobotState that shows the same mode: clients wait for the
// message and look at their newest state then. So a change of the safety mode brings a state out of turn,
// and a client that has no room for that state does not get the message either.
// Source: client interface manual.

#include "robot/simulator/servers/net/server.h"
#include "robot/simulator/servers/primary/primary_messages.h"
#include "robot/simulator/servers/service/script_intake.h"

namespace tiller::simulator {

class PrimaryServer final : public Server {
public:
    /// messages  primary: all messages; otherwise only the version, at connect
    PrimaryServer(Plant& plant, bool messages, bool acceptsScripts);

    void service() override;
    using Server::publish;
    /// Sends what a control period brought: the robot's state when it is time for one, and behind it the
    /// messages. Of several changes of the safety mode the last is told, which is the one the state shows.
    void publish(const std::vector<primary::Bytes>& messages);
    void closeClients() override { clients_.clear(); }

private:
    struct Client {
        Client(native_socket::Descriptor descriptor, bool mayWrite)
            : peer(descriptor, 64 * 1024), intake(mayWrite) {}
        Peer peer;
        ScriptIntake intake;
        std::uint64_t program = 0;  ///< program whose variables it has received
        std::uint64_t knows = 0;    ///< the identity whose KinematicsInfo and ConfigurationData it has had
        bool hasState = false;      ///< the state of this control period was sent to it
    };

    void sendStates(bool evenToTheSlow);
    void sendMessages(const std::vector<primary::Bytes>& messages);
    void publishVariables();

    Plant& plant_;
    std::vector<primary::Bytes> lastValues_;
    bool messages_;
    bool acceptsScripts_;
    double nextState_ = 0;  ///< [s] since the plant was made
    std::vector<std::unique_ptr<Client>> clients_;
};

}  // namespace tiller::simulator
