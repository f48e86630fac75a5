// SPDX-License-Identifier: MIT
#include "tests/support/rtde_peer.h"

#include "robot/rtde/fields.h"
#include "robot/rtde/values.h"

namespace tiller::test {

using namespace rtde;

RtdePeer::RtdePeer(RtdePeerOptions options) : options_(std::move(options)) {
    peer_ = std::make_unique<ScriptedPeer>([this](ScriptedPeer::Link& link) { serve(link); }, options_.port);
}

void RtdePeer::set(const std::string& field, std::vector<double> values) {
    const std::lock_guard lock(mutex_);
    values_[field] = std::move(values);
}

void RtdePeer::send(double timestamp) {
    const std::lock_guard lock(mutex_);
    toSend_.push_back(timestamp);
}

void RtdePeer::sendRaw(Bytes bytes) {
    const std::lock_guard lock(mutex_);
    rawToSend_.push_back(std::move(bytes));
}

SetupOutputsRequest RtdePeer::outputs() const {
    const std::lock_guard lock(mutex_);
    return outputs_;
}

std::vector<double> RtdePeer::input(const std::string& field) const {
    const std::lock_guard lock(mutex_);
    const auto found = inputs_.find(field);
    return found == inputs_.end() ? std::vector<double>() : found->second;
}

/// The state of one connection.
struct RtdePeer::Conversation {
    struct InputRecipe {
        std::vector<std::string> names;
        ValueLayout layout;
    };

    RtdePeer& peer;
    ScriptedPeer::Link& link;
    ProtocolVersion protocol = ProtocolVersion::V1;
    std::vector<std::string> names;
    ValueLayout layout;
    bool outputsValid = false;
    std::vector<InputRecipe> inputs;

    std::vector<FieldAnswer> answer(const std::vector<std::string>& asked,
                                    const Field* (*find)(std::string_view), bool& valid) {
        std::vector<FieldAnswer> answers;
        valid = true;
        for (const std::string& name : asked) {
            const Field* field = find(name);
            if (field == nullptr || peer.options_.missing.count(name) != 0) {
                answers.push_back(FieldAnswer::notFound());
                valid = false;
            } else if (find == &findInput && peer.options_.inUse.count(name) != 0) {
                answers.push_back(FieldAnswer::inUse());
                valid = false;
            } else {
                answers.push_back(FieldAnswer::of(field->type));
            }
        }
        return answers;
    }

    static ValueLayout layoutOf(const std::vector<FieldAnswer>& answers) {
        std::vector<DataType> types;
        for (const FieldAnswer& field : answers) {
            types.push_back(field.type);
        }
        return ValueLayout(std::move(types));
    }

    void handle(const PackageView& package) {
        Bytes out;
        if (peer.options_.textBeforeEveryReply && package.type != PackageType::Data) {
            writeControllerText(out, protocol,
                                {TextLevel::Warning, "SafetySetup has not been confirmed yet", "peer"});
        }
        switch (package.type) {
            case PackageType::RequestProtocolVersion: {
                const int wanted = readProtocolRequest(package.payload).value();
                const bool accepted = wanted >= 1 && wanted <= peer.options_.highestProtocol;
                if (accepted) {
                    protocol = static_cast<ProtocolVersion>(wanted);
                }
                writeProtocolReply(out, accepted);
                break;
            }
            case PackageType::GetUrControlVersion:
                writeVersionReply(out, peer.options_.version);
                break;
            case PackageType::SetupOutputs: {
                const auto request = readSetupOutputsRequest(package.payload, protocol).value();
                const auto answers = answer(request.names, &findOutput, outputsValid);
                names = request.names;
                layout = outputsValid ? layoutOf(answers) : ValueLayout();
                {
                    const std::lock_guard lock(peer.mutex_);
                    peer.outputs_ = request;
                }
                writeSetupOutputsReply(out, protocol, outputsValid ? 1 : 0, answers);
                break;
            }
            case PackageType::SetupInputs: {
                const auto asked = readSetupInputsRequest(package.payload).value();
                bool valid = false;
                const auto answers = answer(asked, &findInput, valid);
                if (valid) {
                    inputs.push_back({asked, layoutOf(answers)});
                }
                writeSetupInputsReply(out, valid ? static_cast<std::uint8_t>(inputs.size()) : 0, answers);
                break;
            }
            case PackageType::Start: {
                const bool accepted = outputsValid && peer.options_.acceptStart;
                peer.started_ = accepted;
                writeStartReply(out, accepted);
                break;
            }
            case PackageType::Pause:
                peer.started_ = false;
                writePauseReply(out, true);
                break;
            case PackageType::Data:
                take(package.payload);
                break;
            case PackageType::TextMessage:
            case PackageType::ReadProperties:  // Tiller's clients do not send this type
                break;
        }
        link.send(out);
    }

    void take(ByteView payload) {
        const auto data = readInputData(payload);
        if (!data || data->recipeId == 0 || data->recipeId > inputs.size()) {
            return;
        }
        const InputRecipe& recipe = inputs[data->recipeId - 1U];
        std::vector<double> values(recipe.layout.components());
        if (!decodeValues(recipe.layout, data->values, values)) {
            return;
        }
        const std::lock_guard lock(peer.mutex_);
        std::size_t at = 0;
        for (std::size_t i = 0; i < recipe.names.size(); ++i) {
            const std::size_t count = componentCount(recipe.layout.types()[i]);
            peer.inputs_[recipe.names[i]].assign(&values[at], &values[at] + count);
            at += count;
        }
        ++peer.inputPackages_;
    }

    void sendSamples() {
        std::deque<double> timestamps;
        std::map<std::string, std::vector<double>> held;
        std::deque<Bytes> raw;
        {
            const std::lock_guard lock(peer.mutex_);
            timestamps.swap(peer.toSend_);
            raw.swap(peer.rawToSend_);
            held = peer.values_;
        }
        for (const double timestamp : timestamps) {
            std::vector<double> values;
            for (std::size_t i = 0; i < names.size(); ++i) {
                const std::size_t count = componentCount(layout.types()[i]);
                std::vector<double> part = held[names[i]];
                if (names[i] == "timestamp") {
                    part = {timestamp};
                }
                part.resize(count);
                values.insert(values.end(), part.begin(), part.end());
            }
            Bytes out(dataPackageSize(layout.wireBytes(), protocol != ProtocolVersion::V1));
            writeDataPackage(out,
                             protocol == ProtocolVersion::V1 ? std::nullopt : std::optional<std::uint8_t>(1),
                             layout, values);
            link.send(out);
        }
        for (const Bytes& bytes : raw) {
            link.send(bytes);
        }
    }
};

void RtdePeer::serve(ScriptedPeer::Link& link) {
    Conversation conversation{*this, link, ProtocolVersion::V1, {}, {}, {}, {}};
    closeWanted_ = false;
    while (!link.isOver() && !closeWanted_.exchange(false)) {
        if (const auto package = link.nextPackage(std::chrono::milliseconds(1))) {
            conversation.handle(*package);
        }
        if (started_) {
            conversation.sendSamples();
        }
    }
    started_ = false;
}

}  // namespace tiller::test
