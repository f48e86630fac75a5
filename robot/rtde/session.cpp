// SPDX-License-Identifier: MIT
#include "robot/rtde/session.h"

#include <algorithm>
#include <cmath>

namespace tiller::rtde {

namespace {

constexpr std::size_t kTextsKept = 32;

/// Lists at most three names, because the names of all registers of a range are too long for a message.
QString listed(const std::vector<std::string>& names) {
    constexpr std::size_t kShown = 3;
    const auto shown =
        std::vector(names.begin(), names.begin() + std::ptrdiff_t(std::min(names.size(), kShown)));
    const QString text =
        QString::fromStdString(joinNames(shown)).replace(QLatin1Char(','), QStringLiteral(", "));
    return names.size() > kShown ? QStringLiteral("%1 and %2 more").arg(text).arg(names.size() - kShown)
                                 : text;
}

QString typeText(PackageType type) {
    return QString::fromLatin1(packageTypeName(type));
}

}  // namespace

Session::Session(SessionRequest request) : request_(std::move(request)) {}

void Session::begin(Bytes& out) {
    if (state_ != State::Idle) {
        return;
    }
    std::vector<const std::vector<std::string>*> lists{&request_.outputs};
    for (const InputRequest& input : request_.inputs) {
        lists.push_back(&input.names);
    }
    for (const auto* list : lists) {
        if (joinNames(*list).size() > kMaxNameListSize) {
            fail(ErrorCode::InvalidArgument,
                 QStringLiteral(
                     "a list of %1 RTDE fields is longer than the %2 bytes that a controller accepts")
                     .arg(list->size())
                     .arg(kMaxNameListSize));
            return;
        }
    }
    state_ = State::AskingProtocol;
    writeProtocolRequest(out, askedProtocol_);
}

void Session::handle(const PackageView& package, Bytes& out) {
    if (state_ == State::Failed || state_ == State::Idle) {
        return;
    }
    switch (package.type) {
        case PackageType::TextMessage:
            keepText(package);
            return;
        case PackageType::Data:
            // The first data package can arrive before the reply to START.
            if (state_ == State::Starting) {
                state_ = State::Running;
            }
            return;
        case PackageType::RequestProtocolVersion:
            if (state_ == State::AskingProtocol) {
                onProtocol(package.payload, out);
            }
            return;
        case PackageType::GetUrControlVersion:
            if (state_ == State::AskingVersion) {
                onVersion(package.payload, out);
            }
            return;
        case PackageType::SetupOutputs:
            if (state_ == State::SettingUpOutputs) {
                onOutputs(package.payload, out);
            }
            return;
        case PackageType::SetupInputs:
            if (state_ == State::SettingUpInputs) {
                onInputs(package.payload, out);
            }
            return;
        case PackageType::Start:
            if (state_ == State::Starting) {
                onStarted(package.payload);
            }
            return;
        case PackageType::Pause:
            if (state_ == State::Pausing) {
                state_ = State::Ready;
            }
            return;
        case PackageType::ReadProperties:
            return;  // not requested
    }
    // Packages of unknown types are ignored.
}

void Session::start(Bytes& out) {
    if (state_ == State::Ready && outputs_.isValid()) {
        state_ = State::Starting;
        writeStartRequest(out);
    }
}

void Session::pause(Bytes& out) {
    if (state_ == State::Running) {
        state_ = State::Pausing;
        writePauseRequest(out);
    }
}

QString Session::awaited() const {
    const auto reply = [](PackageType type) { return QStringLiteral("the reply to ") + typeText(type); };
    switch (state_) {
        case State::AskingProtocol:
            return reply(PackageType::RequestProtocolVersion);
        case State::AskingVersion:
            return reply(PackageType::GetUrControlVersion);
        case State::SettingUpOutputs:
            return reply(PackageType::SetupOutputs);
        case State::SettingUpInputs:
            return reply(PackageType::SetupInputs);
        case State::Starting:
            return reply(PackageType::Start);
        case State::Pausing:
            return reply(PackageType::Pause);
        case State::Running:
            return QStringLiteral("data");
        case State::Idle:
        case State::Ready:
        case State::Failed:
            break;
    }
    return {};
}

double Session::period() const {
    const double steps = std::max(1.0, std::floor(version_.maxFrequency() / requestedFrequency() + 1e-9));
    return steps * version_.controlPeriod();
}

double Session::requestedFrequency() const {
    const double most = version_.maxFrequency();
    // Version 1 has no frequency field: data arrive at the maximum rate.
    if (protocol_ == ProtocolVersion::V1 || !(request_.frequency > 0)) {
        return most;
    }
    return std::clamp(request_.frequency, 1.0, most);
}

void Session::onProtocol(ByteView payload, Bytes& out) {
    const auto accepted = readAccepted(payload, PackageType::RequestProtocolVersion);
    if (!accepted) {
        fail(accepted.error().code, accepted.error().context);
        return;
    }
    if (*accepted) {
        protocol_ = static_cast<ProtocolVersion>(askedProtocol_);
    } else if (askedProtocol_ == 2) {
        askedProtocol_ = 1;
        writeProtocolRequest(out, askedProtocol_);
        return;
    }
    // If the controller has refused version 1 too, continue, because version 1 is the default without
    // negotiation.
    state_ = State::AskingVersion;
    writeVersionRequest(out);
}

void Session::onVersion(ByteView payload, Bytes& out) {
    const auto version = readVersionReply(payload);
    if (!version) {
        fail(version.error().code, version.error().context);
        return;
    }
    version_ = *version;
    if (request_.outputs.empty()) {
        afterOutputs(out);
        return;
    }
    asked_ = request_.outputs;
    absent_.clear();
    state_ = State::SettingUpOutputs;
    askOutputs(out);
}

void Session::askOutputs(Bytes& out) {
    writeSetupOutputsRequest(out, protocol_, requestedFrequency(), asked_);
}

void Session::onOutputs(ByteView payload, Bytes& out) {
    const auto reply = readSetupOutputsReply(payload, protocol_);
    if (!reply) {
        fail(reply.error().code, reply.error().context);
        return;
    }
    if (reply->fields.size() != asked_.size()) {
        fail(ErrorCode::ProtocolError, QStringLiteral("%1: the reply lists %2 types for %3 fields")
                                           .arg(typeText(PackageType::SetupOutputs))
                                           .arg(reply->fields.size())
                                           .arg(asked_.size()));
        return;
    }
    Recipe recipe(reply->recipeId, asked_, reply->fields);
    if (!recipe.absent_.empty()) {
        absent_.insert(absent_.end(), recipe.absent_.begin(), recipe.absent_.end());
        if (recipe.fields_.empty()) {
            fail(ErrorCode::FieldUnknown,
                 QStringLiteral("the controller does not provide the outputs %1").arg(listed(absent_)));
            return;
        }
        asked_.clear();
        for (const RecipeField& field : recipe.fields_) {
            asked_.push_back(field.name);
        }
        askOutputs(out);
        return;
    }
    if (!recipe.isValid()) {
        fail(ErrorCode::Rejected, QStringLiteral("the controller refused the output recipe"));
        return;
    }
    outputs_ = std::move(recipe);
    outputs_.absent_ = absent_;
    afterOutputs(out);
}

void Session::afterOutputs(Bytes& out) {
    if (inputs_.size() == request_.inputs.size()) {
        afterInputs(out);
        return;
    }
    asked_ = request_.inputs[inputs_.size()].names;
    absent_.clear();
    state_ = State::SettingUpInputs;
    askInputs(out);
}

void Session::askInputs(Bytes& out) {
    writeSetupInputsRequest(out, asked_);
}

void Session::onInputs(ByteView payload, Bytes& out) {
    const auto reply = readSetupInputsReply(payload);
    if (!reply) {
        fail(reply.error().code, reply.error().context);
        return;
    }
    if (reply->fields.size() != asked_.size()) {
        fail(ErrorCode::ProtocolError, QStringLiteral("%1: the reply lists %2 types for %3 fields")
                                           .arg(typeText(PackageType::SetupInputs))
                                           .arg(reply->fields.size())
                                           .arg(asked_.size()));
        return;
    }
    const bool required = request_.inputs[inputs_.size()].required;
    std::vector<std::string> known;
    std::vector<std::string> taken;
    for (std::size_t i = 0; i < asked_.size(); ++i) {
        switch (reply->fields[i].kind) {
            case FieldAnswer::Kind::Type:
                known.push_back(asked_[i]);
                break;
            case FieldAnswer::Kind::NotFound:
                absent_.push_back(asked_[i]);
                break;
            case FieldAnswer::Kind::InUse:
                taken.push_back(asked_[i]);
                break;
        }
    }
    Recipe recipe;
    if (!taken.empty()) {
        if (required) {
            fail(ErrorCode::RegisterInUse,
                 QStringLiteral("another RTDE client or a fieldbus uses %1").arg(listed(taken)));
            return;
        }
    } else if (known.size() < asked_.size() && !known.empty()) {
        asked_ = std::move(known);
        askInputs(out);
        return;
    } else if (!known.empty()) {
        if (reply->recipeId == 0 && required) {
            fail(ErrorCode::Rejected,
                 QStringLiteral("the controller refused the input recipe %1").arg(listed(asked_)));
            return;
        }
        recipe = Recipe(reply->recipeId, asked_, reply->fields);
    }
    recipe.absent_ = absent_;
    inputs_.push_back(std::move(recipe));
    inUse_.push_back(std::move(taken));
    afterOutputs(out);
}

void Session::afterInputs(Bytes& out) {
    state_ = State::Ready;
    if (request_.start) {
        start(out);
    }
}

void Session::onStarted(ByteView payload) {
    const auto accepted = readAccepted(payload, PackageType::Start);
    if (!accepted) {
        fail(accepted.error().code, accepted.error().context);
    } else if (!*accepted) {
        fail(ErrorCode::Rejected, QStringLiteral("the controller refused to start sending data"));
    } else {
        state_ = State::Running;
    }
}

void Session::fail(ErrorCode code, const QString& context, const QString& message) {
    state_ = State::Failed;
    error_ = {code, context, message};
}

void Session::keepText(const PackageView& package) {
    auto text = readControllerText(package.payload, protocol_);
    if (!text && protocol_ == ProtocolVersion::V2) {
        // The message may have been sent before version 2 was negotiated.
        text = readControllerText(package.payload, ProtocolVersion::V1);
    }
    if (!text) {
        return;  // a malformed text does not end the connection
    }
    if (texts_.size() == kTextsKept) {
        texts_.erase(texts_.begin());
    }
    texts_.push_back(std::move(text).value());
}

}  // namespace tiller::rtde
