// SPDX-License-Identifier: MIT
// Requests, replies and text messages of the setup. They are infrequent and short, so these functions may
// allocate.
#include "robot/rtde/codec.h"

#include <algorithm>

#include "robot/rtde/big_endian.h"

namespace tiller::rtde {

namespace {

constexpr std::string_view kNotFound = "NOT_FOUND";
constexpr std::string_view kInUse = "IN_USE";
constexpr std::size_t kMaxText = 255;

Error malformed(PackageType type, const QString& what) {
    return {ErrorCode::ProtocolError,
            QStringLiteral("%1: %2").arg(QLatin1String(packageTypeName(type)), what),
            {}};
}

Error wrongSize(PackageType type, std::size_t expected, std::size_t got) {
    return malformed(type, QStringLiteral("payload of %1 bytes instead of %2").arg(got).arg(expected));
}

/// Appends a package whose payload is appended by `fill`, and sets the package size. A payload too large for
/// the size field is truncated. No caller produces such a payload, and a wrong size would corrupt the stream
/// permanently.
template <class Fill>
void writePackage(Bytes& out, PackageType type, Fill fill) {
    const std::size_t start = out.size();
    out.resize(start + kHeaderSize);
    fill();
    const std::size_t size = std::min(out.size() - start, kMaxPackageSize);
    out.resize(start + size);
    big_endian::write16(&out[start], static_cast<std::uint16_t>(size));
    out[start + 2] = static_cast<std::uint8_t>(type);
}

void writeEmpty(Bytes& out, PackageType type) {
    writePackage(out, type, [] {});
}

void writeByte(Bytes& out, PackageType type, std::uint8_t value) {
    writePackage(out, type, [&] { out.push_back(value); });
}

void append(Bytes& out, std::string_view text) {
    out.insert(out.end(), text.begin(), text.end());
}

void append32(Bytes& out, std::uint32_t value) {
    out.resize(out.size() + 4);
    big_endian::write32(&out[out.size() - 4], value);
}

void appendText(Bytes& out, std::string_view text) {
    text = text.substr(0, kMaxText);
    out.push_back(static_cast<std::uint8_t>(text.size()));
    append(out, text);
}

void appendAnswers(Bytes& out, std::span<const FieldAnswer> fields) {
    bool first = true;
    for (const FieldAnswer& field : fields) {
        if (!first) {
            out.push_back(',');
        }
        first = false;
        switch (field.kind) {
            case FieldAnswer::Kind::Type:
                append(out, dataTypeName(field.type));
                break;
            case FieldAnswer::Kind::NotFound:
                append(out, kNotFound);
                break;
            case FieldAnswer::Kind::InUse:
                append(out, kInUse);
                break;
        }
    }
}

std::string_view asText(ByteView bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

QString inQuotes(std::string_view text) {
    constexpr std::size_t kLongest = 60;
    return QStringLiteral("\"%1\"").arg(
        QString::fromLatin1(text.data(), static_cast<qsizetype>(std::min(text.size(), kLongest))));
}

Result<std::vector<FieldAnswer>> readAnswers(std::string_view list, PackageType type) {
    std::vector<FieldAnswer> answers;
    for (const std::string& word : splitNames(list)) {
        if (word == kNotFound) {
            answers.push_back(FieldAnswer::notFound());
        } else if (word == kInUse) {
            answers.push_back(FieldAnswer::inUse());
        } else if (const auto known = dataTypeByName(word)) {
            answers.push_back(FieldAnswer::of(*known));
        } else {
            return malformed(type, QStringLiteral("unknown data type ") + inQuotes(word));
        }
    }
    return answers;
}

Result<SetupReply> readReplyWithId(ByteView payload, PackageType type) {
    if (payload.empty()) {
        return malformed(type, QStringLiteral("empty reply, the recipe id is missing"));
    }
    auto answers = readAnswers(asText(payload.subspan(1)), type);
    if (!answers) {
        return answers.error();
    }
    return SetupReply{payload[0], std::move(answers).value()};
}

/// Layout: message length, message, source length, source, level. Used in both directions in version 2, and towards
/// the controller in both versions.
Result<TextMessage> readLongText(ByteView payload) {
    constexpr auto kType = PackageType::TextMessage;
    TextMessage text;
    std::size_t at = 0;
    for (std::string* part : {&text.message, &text.source}) {
        if (at >= payload.size()) {
            return malformed(kType, QStringLiteral("ends before a length"));
        }
        const std::size_t length = payload[at++];
        if (length > payload.size() - at) {
            return malformed(kType, QStringLiteral("declares %1 characters, but only %2 remain")
                                        .arg(length)
                                        .arg(payload.size() - at));
        }
        *part = asText(payload.subspan(at, length));
        at += length;
    }
    if (payload.size() != at + 1) {
        return wrongSize(kType, at + 1, payload.size());
    }
    if (payload[at] > static_cast<std::uint8_t>(TextLevel::Info)) {
        return malformed(kType, QStringLiteral("unknown level %1").arg(payload[at]));
    }
    text.level = static_cast<TextLevel>(payload[at]);
    return text;
}

void writeLongText(Bytes& out, const TextMessage& text) {
    writePackage(out, PackageType::TextMessage, [&] {
        appendText(out, text.message);
        appendText(out, text.source);
        out.push_back(static_cast<std::uint8_t>(text.level));
    });
}

}  // namespace

std::vector<std::string> splitNames(std::string_view list) {
    std::vector<std::string> names;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        names.emplace_back(list.substr(0, comma));
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return names;
}

std::string joinNames(std::span<const std::string> names) {
    std::string list;
    for (const std::string& name : names) {
        if (!list.empty()) {
            list += ',';
        }
        list += name;
    }
    return list;
}

void writeProtocolRequest(Bytes& out, std::uint16_t version) {
    writePackage(out, PackageType::RequestProtocolVersion, [&] {
        out.push_back(static_cast<std::uint8_t>(version >> 8));
        out.push_back(static_cast<std::uint8_t>(version & 0xFF));
    });
}

void writeVersionRequest(Bytes& out) {
    writeEmpty(out, PackageType::GetUrControlVersion);
}

void writeSetupOutputsRequest(Bytes& out, ProtocolVersion version, double frequency,
                              std::span<const std::string> names) {
    writePackage(out, PackageType::SetupOutputs, [&] {
        if (version != ProtocolVersion::V1) {
            out.resize(out.size() + 8);
            big_endian::writeDouble(&out[out.size() - 8], frequency);
        }
        append(out, joinNames(names));
    });
}

void writeSetupInputsRequest(Bytes& out, std::span<const std::string> names) {
    writePackage(out, PackageType::SetupInputs, [&] { append(out, joinNames(names)); });
}

void writeStartRequest(Bytes& out) {
    writeEmpty(out, PackageType::Start);
}

void writePauseRequest(Bytes& out) {
    writeEmpty(out, PackageType::Pause);
}

void writeClientText(Bytes& out, const TextMessage& text) {
    writeLongText(out, text);
}

void writeProtocolReply(Bytes& out, bool accepted) {
    writeByte(out, PackageType::RequestProtocolVersion, accepted ? 1 : 0);
}

void writeVersionReply(Bytes& out, const SoftwareVersion& version) {
    writePackage(out, PackageType::GetUrControlVersion, [&] {
        append32(out, version.major);
        append32(out, version.minor);
        append32(out, version.bugfix);
        append32(out, version.build);
    });
}

void writeSetupOutputsReply(Bytes& out, ProtocolVersion version, std::uint8_t recipeId,
                            std::span<const FieldAnswer> fields) {
    writePackage(out, PackageType::SetupOutputs, [&] {
        if (version != ProtocolVersion::V1) {
            out.push_back(recipeId);
        }
        appendAnswers(out, fields);
    });
}

void writeSetupInputsReply(Bytes& out, std::uint8_t recipeId, std::span<const FieldAnswer> fields) {
    writePackage(out, PackageType::SetupInputs, [&] {
        out.push_back(recipeId);
        appendAnswers(out, fields);
    });
}

void writeStartReply(Bytes& out, bool accepted) {
    writeByte(out, PackageType::Start, accepted ? 1 : 0);
}

void writePauseReply(Bytes& out, bool accepted) {
    writeByte(out, PackageType::Pause, accepted ? 1 : 0);
}

void writeControllerText(Bytes& out, ProtocolVersion version, const TextMessage& text) {
    if (version != ProtocolVersion::V1) {
        writeLongText(out, text);
        return;
    }
    writePackage(out, PackageType::TextMessage, [&] {
        out.push_back(static_cast<std::uint8_t>(text.level));
        append(out, std::string_view(text.message).substr(0, kMaxText));
    });
}

void writeReadPropertiesReply(Bytes& out, std::string_view types, ByteView values) {
    writePackage(out, PackageType::ReadProperties, [&] {
        out.resize(out.size() + 2);
        big_endian::write16(&out[out.size() - 2], static_cast<std::uint16_t>(types.size()));
        append(out, types);
        out.insert(out.end(), values.begin(), values.end());
    });
}

Result<std::uint16_t> readProtocolRequest(ByteView payload) {
    if (payload.size() != 2) {
        return wrongSize(PackageType::RequestProtocolVersion, 2, payload.size());
    }
    return big_endian::read16(payload.data());
}

Result<SetupOutputsRequest> readSetupOutputsRequest(ByteView payload, ProtocolVersion version) {
    SetupOutputsRequest request;
    if (version != ProtocolVersion::V1) {
        if (payload.size() < 8) {
            return malformed(
                PackageType::SetupOutputs,
                QStringLiteral("the payload has only %1 bytes; the frequency field alone requires 8")
                    .arg(payload.size()));
        }
        request.frequency = big_endian::readDouble(payload.data());
        payload = payload.subspan(8);
    }
    request.names = splitNames(asText(payload));
    return request;
}

Result<std::vector<std::string>> readSetupInputsRequest(ByteView payload) {
    return splitNames(asText(payload));
}

Result<TextMessage> readClientText(ByteView payload) {
    return readLongText(payload);
}

std::vector<std::string> readPropertiesRequest(ByteView payload) {
    return splitNames(asText(payload));
}

Result<bool> readAccepted(ByteView payload, PackageType type) {
    if (payload.size() != 1) {
        return wrongSize(type, 1, payload.size());
    }
    return payload[0] != 0;
}

Result<SoftwareVersion> readVersionReply(ByteView payload) {
    if (payload.size() != 16) {
        return wrongSize(PackageType::GetUrControlVersion, 16, payload.size());
    }
    const std::uint8_t* p = payload.data();
    return SoftwareVersion{big_endian::read32(p), big_endian::read32(p + 4), big_endian::read32(p + 8),
                           big_endian::read32(p + 12)};
}

Result<SetupReply> readSetupOutputsReply(ByteView payload, ProtocolVersion version) {
    if (version != ProtocolVersion::V1) {
        return readReplyWithId(payload, PackageType::SetupOutputs);
    }
    auto answers = readAnswers(asText(payload), PackageType::SetupOutputs);
    if (!answers) {
        return answers.error();
    }
    SetupReply reply{1, std::move(answers).value()};
    const bool complete = std::all_of(reply.fields.begin(), reply.fields.end(),
                                      [](const FieldAnswer& f) { return f.kind == FieldAnswer::Kind::Type; });
    if (!complete || reply.fields.empty()) {
        reply.recipeId = 0;
    }
    return reply;
}

Result<SetupReply> readSetupInputsReply(ByteView payload) {
    return readReplyWithId(payload, PackageType::SetupInputs);
}

Result<TextMessage> readControllerText(ByteView payload, ProtocolVersion version) {
    if (version != ProtocolVersion::V1) {
        return readLongText(payload);
    }
    if (payload.empty()) {
        return malformed(PackageType::TextMessage, QStringLiteral("empty, the level is missing"));
    }
    if (payload[0] > static_cast<std::uint8_t>(TextLevel::Info)) {
        return malformed(PackageType::TextMessage, QStringLiteral("unknown level %1").arg(payload[0]));
    }
    return TextMessage{static_cast<TextLevel>(payload[0]), std::string(asText(payload.subspan(1))), {}};
}

}  // namespace tiller::rtde
