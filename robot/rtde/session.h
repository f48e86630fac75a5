// SPDX-License-Identifier: MIT
#pragma once

// The client's side of an RTDE connection as a state machine without any I/O: packages in, bytes to send and
// a state out. It asks for protocol 2 and is content with 1, reads the version, sets up outputs and inputs
// (again without the fields the robot does not know), starts, and can pause and resume. Text messages and
// late data packages may come at any point. Source: RTDE guide.

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
    /// What to do when another client or a fieldbus owns one of the names: true ends the session with
    /// RegisterInUse, false leaves this recipe invalid and goes on (see Session::inUse).
    bool required = true;
};

struct SessionRequest {
    /// Outputs wanted, in the order their values shall come. Empty: no data asked for.
    std::vector<std::string> outputs;
    /// Packages a second; 0 asks for the most the controller offers. Held to 1 .. the controller's maximum.
    double frequency = 0;
    std::vector<InputRequest> inputs;
    /// Send START at the end of the handshake. Only with outputs; inputs alone need none.
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
        Ready,    ///< handshake done, not started (no outputs, or start was not wanted)
        Running,  ///< data come
        Pausing,
        Failed,  ///< see error(); nothing gets it out of here
    };

    explicit Session(SessionRequest request);

    /// The first request. All functions append what is to be sent to `out`.
    void begin(Bytes& out);
    /// Takes any package except a data package while running (the caller decodes those itself).
    void handle(const PackageView& package, Bytes& out);
    /// From Ready or Running; ignored otherwise.
    void start(Bytes& out);
    void pause(Bytes& out);  ///< Appends the request.

    State state() const { return state_; }                     ///< Of the handshake.
    bool isFailed() const { return state_ == State::Failed; }  ///< See error().
    /// True once the handshake came to its end.
    bool isReady() const { return state_ == State::Ready || state_ == State::Running; }
    const Error& error() const { return error_; }  ///< Why it failed.
    /// What is being waited for, for messages: "the reply to RTDE_GET_URCONTROL_VERSION".
    QString awaited() const;

    ProtocolVersion protocol() const { return protocol_; }       ///< Agreed upon.
    const SoftwareVersion& version() const { return version_; }  ///< Of the controller.
    const Recipe& outputs() const { return outputs_; }           ///< Of the data packages.
    /// As many as were requested, in that order; one that was refused is invalid.
    const std::vector<Recipe>& inputs() const { return inputs_; }
    /// Names owned by others, per input recipe.
    const std::vector<std::vector<std::string>>& inUse() const { return inUse_; }
    /// Time between two data packages [s]: a whole number of control steps.
    double period() const;
    /// Text messages that came so far; the newest 32 are kept.
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
    std::vector<std::string> asked_;   ///< names of the setup request under way
    std::vector<std::string> absent_;  ///< names dropped from it so far
    std::vector<TextMessage> texts_;
};

}  // namespace tiller::rtde
