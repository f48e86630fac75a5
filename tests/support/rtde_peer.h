// SPDX-License-Identifier: MIT
#pragma once

// A robot that speaks RTDE and nothing else: enough of the controller's side to test clients against, with
// the behaviour a test wants. It has no arm; the test says what the next package holds.

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
    std::set<std::string> missing;  ///< outputs and inputs this robot does not have
    std::set<std::string> inUse;    ///< inputs somebody else owns
    bool textBeforeEveryReply = false;
    bool acceptStart = true;
    std::uint16_t port = 0;
};

/// Threads  the functions are called by the test; the peer serves in its own thread
class RtdePeer {
public:
    explicit RtdePeer(RtdePeerOptions options = {});

    std::uint16_t port() const { return peer_->port(); }
    int connections() const { return peer_->connections(); }
    bool isStarted() const { return started_; }

    /// What the packages hold from now on; 0 for anything not set.
    void set(const std::string& field, std::vector<double> values);
    /// Sends one package with this time stamp as soon as the client has started.
    void send(double timestamp);
    /// Hangs up.
    void closeConnection() { closeWanted_ = true; }
    /// Garbage in place of a package.
    void sendRaw(rtde::Bytes bytes);

    /// Names and frequency of the last setup of outputs.
    rtde::SetupOutputsRequest outputs() const;
    /// The last values received for an input; empty when there was none.
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
    std::unique_ptr<ScriptedPeer> peer_;  // last: its thread uses all of the above
};

}  // namespace tiller::test
