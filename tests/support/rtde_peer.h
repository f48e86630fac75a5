// SPDX-License-Identifier: MIT
#pragma once

// A minimal RTDE server that provides enough of the controller's side to test clients, with configurable
// behaviour. It has no arm. The test defines the content of the packages.

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "robot/core/version.h"
#include "tests/support/scripted_peer.h"

namespace tiller::test {

struct RtdePeerOptions {
    int highestProtocol = 2;
    SoftwareVersion version{5, 22, 1, 0};
    std::set<std::string> missing;  ///< outputs and inputs that the robot does not have
    std::set<std::string> inUse;    ///< inputs that other clients use
    bool textBeforeEveryReply = false;
    bool acceptStart = true;
    std::uint16_t port = 0;
};

/// Threads: the test calls the functions, and the peer serves in its own thread.
class RtdePeer {
public:
    explicit RtdePeer(RtdePeerOptions options = {});

    std::uint16_t port() const { return peer_->port(); }
    int connections() const { return peer_->connections(); }
    bool isStarted() const { return started_; }

    /// Sets a value in all later packages. Values that are not set are 0.
    void set(const std::string& field, std::vector<double> values);
    /// Sends one package with this time stamp after the client has started.
    void send(double timestamp);
    void closeConnection() { closeWanted_ = true; }
    /// Sends arbitrary bytes instead of a package.
    void sendRaw(rtde::Bytes bytes);

    /// Names and frequency of the last output setup request.
    rtde::SetupOutputsRequest outputs() const;
    /// The last values received for an input; empty if none were received.
    std::vector<double> input(const std::string& field) const;
    int inputPackages() const { return inputPackages_; }

private:
    struct Conversation;
    void serve(ScriptedPeer::Link& link);

    RtdePeerOptions options_;
    mutable std::mutex mutex_;
    std::map<std::string, std::vector<double>> values_;
    std::map<std::string, std::vector<double>> inputs_;
    rtde::SetupOutputsRequest outputs_;
    std::deque<double> toSend_;
    std::deque<rtde::Bytes> rawToSend_;
    std::atomic<bool> started_{false};
    std::atomic<bool> closeWanted_{false};
    std::atomic<int> inputPackages_{0};
    std::unique_ptr<ScriptedPeer> peer_;  // last member, because its thread uses all others
};

}  // namespace tiller::test
