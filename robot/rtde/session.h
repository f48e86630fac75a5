// SPDX-License-Identifier: MIT
#pragma once

// Client side of an RTDE connection as a state machine without I/O: it consumes packages and produces the
// bytes to send. It negotiates protocol 2 (or 1), reads the controller version, sets up outputs and inputs,
// and starts, pauses and resumes the data. If a field is unknown to the robot, the setup request is repeated
// without the field. Text messages and delayed data packages may arrive in any state. Source: RTDE guide.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robot/core/error.h"
#include "robot/core/version.h"
#include "robot/rtde/codec.h"
#include "robot/rtde/recipe.h"
#include "robot/rtde/splitter.h"

namespace tiller::rtde {

/// One input recipe to set up.
struct InputRequest {
    std::vector<std::string> names;
    /// If another client or a fieldbus uses one of the names: true fails the session with RegisterInUse,
    /// false marks only this recipe as invalid (see Session::inUse()).
    bool required = true;
};

struct SessionRequest {
    /// Requested outputs, in the order of the decoded values. Empty: no data packages.
    std::vector<std::string> outputs;
    /// Packages per second, clamped to 1 ... the maximum of the controller. 0 requests this maximum.
    double frequency = 0;
    std::vector<InputRequest> inputs;
    /// Sends START at the end of the handshake. Ignored without outputs.
    bool start = true;
};

class Session {
public:
    enum class State {
        Idle,
        AskingProtocol,
        AskingVersion,
        SettingUpOutputs,
        SettingUpInputs,
        Starting,
        Ready,    ///< handshake complete, not started (no outputs, or `start` is false)
        Running,  ///< data packages arrive
        Pausing,
        Failed,  ///< see error(); final
    };

    explicit Session(SessionRequest request);

    /// Appends the first request to `out`. handle(), start() and pause() also append the bytes to be sent.
    void begin(Bytes& out);
    /// Processes any package, except for data packages while running, which the caller decodes.
    void handle(const PackageView& package, Bytes& out);
    /// Requests data packages. Allowed in Ready and Running; ignored otherwise.
    void start(Bytes& out);
    void pause(Bytes& out);

    State state() const { return state_; }
    bool isFailed() const { return state_ == State::Failed; }
    /// True once the handshake is complete.
    bool isReady() const { return state_ == State::Ready || state_ == State::Running; }
    const Error& error() const { return error_; }  ///< The reason for State::Failed.
    /// The pending reply, for messages, e.g. "the reply to RTDE_GET_URCONTROL_VERSION".
    QString awaited() const;

    ProtocolVersion protocol() const { return protocol_; }
    const SoftwareVersion& version() const { return version_; }
    const Recipe& outputs() const { return outputs_; }  ///< Recipe of the data packages.
    /// One recipe per InputRequest, in the same order; a refused recipe is invalid.
    const std::vector<Recipe>& inputs() const { return inputs_; }
    /// Names used by other clients, per input recipe.
    const std::vector<std::vector<std::string>>& inUse() const { return inUse_; }
    /// Time between two data packages [s]: a multiple of the control period.
    double period() const;
    /// The newest 32 text messages.
    const std::vector<TextMessage>& texts() const { return texts_; }

private:
    void onProtocol(ByteView payload, Bytes& out);
    void onVersion(ByteView payload, Bytes& out);
    void onOutputs(ByteView payload, Bytes& out);
    void onInputs(ByteView payload, Bytes& out);
    void onStarted(ByteView payload);
    void askOutputs(Bytes& out);
    void askInputs(Bytes& out);
    void afterOutputs(Bytes& out);
    void afterInputs(Bytes& out);
    void fail(ErrorCode code, const QString& context, const QString& message = {});
    void keepText(const PackageView& package);
    double requestedFrequency() const;

    SessionRequest request_;
    State state_ = State::Idle;
    Error error_;
    ProtocolVersion protocol_ = ProtocolVersion::V1;
    std::uint16_t askedProtocol_ = 2;
    SoftwareVersion version_;
    Recipe outputs_;
    std::vector<Recipe> inputs_;
    std::vector<std::vector<std::string>> inUse_;
    std::vector<std::string> asked_;   ///< names in the pending setup request
    std::vector<std::string> absent_;  ///< names removed from this request so far
    std::vector<TextMessage> texts_;
};

}  // namespace tiller::rtde
