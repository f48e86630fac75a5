// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>

#include "robot/rtde/codec.h"
#include "robot/rtde/splitter.h"
#include "robot/rtde/values.h"

using namespace tiller;
using namespace tiller::rtde;

namespace {

Bytes bytes(std::initializer_list<int> list) {
    Bytes out;
    for (const int b : list) {
        out.push_back(static_cast<std::uint8_t>(b));
    }
    return out;
}

Bytes withText(Bytes head, std::string_view text) {
    head.insert(head.end(), text.begin(), text.end());
    return head;
}

/// Extracts the only package from a buffer and keeps a copy of its payload.
struct Taken {
    PackageType type{};
    Bytes payload;
};

Taken only(const Bytes& stream) {
    PackageSplitter splitter;
    if (splitter.feed(stream) != stream.size()) {
        qFatal("no package was extracted");
    }
    const auto package = splitter.next();
    if (!package || splitter.hasNext()) {
        qFatal("not exactly one package");
    }
    return {package->type, Bytes(package->payload.begin(), package->payload.end())};
}

}  // namespace

class TestCodec : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void requestsHaveTheDocumentedBytes();
    void repliesHaveTheDocumentedBytes();
    void setupExampleOfTheGuideIsReproduced();
    void everyPackageRoundTrips_data();
    void everyPackageRoundTrips();
    void versionOneCarriesNoFrequencyAndNoRecipeId();
    void textMessagesRoundTripInBothVersions();
    void longTextsAreTruncated();
    void aTrailingCommaIsNotAField();
    void malformedPayloadsGiveAnError_data();
    void malformedPayloadsGiveAnError();
};

void TestCodec::requestsHaveTheDocumentedBytes() {
    Bytes out;
    writeProtocolRequest(out, 2);
    QCOMPARE(out, bytes({0, 5, 0x56, 0, 2}));
    out.clear();
    writeVersionRequest(out);
    QCOMPARE(out, bytes({0, 3, 0x76}));
    out.clear();
    writeStartRequest(out);
    QCOMPARE(out, bytes({0, 3, 0x53}));
    out.clear();
    writePauseRequest(out);
    QCOMPARE(out, bytes({0, 3, 0x50}));
    // The package is appended; existing content is kept.
    writeStartRequest(out);
    QCOMPARE(out, bytes({0, 3, 0x50, 0, 3, 0x53}));
}

void TestCodec::repliesHaveTheDocumentedBytes() {
    Bytes out;
    writeProtocolReply(out, true);
    QCOMPARE(out, bytes({0, 4, 0x56, 1}));
    out.clear();
    writeProtocolReply(out, false);
    QCOMPARE(out, bytes({0, 4, 0x56, 0}));
    out.clear();
    writeStartReply(out, true);
    QCOMPARE(out, bytes({0, 4, 0x53, 1}));
    out.clear();
    writePauseReply(out, true);
    QCOMPARE(out, bytes({0, 4, 0x50, 1}));
    out.clear();
    writeVersionReply(out, {5, 22, 1, 1214700});
    QCOMPARE(out, bytes({0, 19, 0x76, 0, 0, 0, 5, 0, 0, 0, 22, 0, 0, 0, 1, 0, 0x12, 0x88, 0xEC}));
}

void TestCodec::setupExampleOfTheGuideIsReproduced() {
    const std::vector<std::string> names{"timestamp", "actual_q"};
    Bytes out;
    writeSetupOutputsRequest(out, ProtocolVersion::V2, 500, names);
    QCOMPARE(out, withText(bytes({0, 0x1D, 0x4F, 0x40, 0x7F, 0x40, 0, 0, 0, 0, 0}), "timestamp,actual_q"));

    const std::array types{FieldAnswer::of(DataType::Double), FieldAnswer::of(DataType::Vector6D)};
    out.clear();
    writeSetupOutputsReply(out, ProtocolVersion::V2, 1, types);
    QCOMPARE(out, withText(bytes({0, 0x13, 0x4F, 1}), "DOUBLE,VECTOR6D"));

    const ValueLayout layout({DataType::Double, DataType::Vector6D});
    std::array<std::uint8_t, 100> data{};
    const std::array<double, 7> values{1, 2, 3, 4, 5, 6, 7};
    QCOMPARE(writeDataPackage(data, 1, layout, values), std::size_t(60));
    QCOMPARE(Bytes(data.begin(), data.begin() + 6), bytes({0, 0x3C, 0x55, 1, 0x3F, 0xF0}));
}

void TestCodec::everyPackageRoundTrips_data() {
    QTest::addColumn<int>("version");
    QTest::newRow("v1") << 1;
    QTest::newRow("v2") << 2;
}

void TestCodec::everyPackageRoundTrips() {
    QFETCH(int, version);
    const auto protocol = static_cast<ProtocolVersion>(version);
    const std::vector<std::string> names{"timestamp", "actual_q", "robot_mode"};
    Bytes out;

    writeProtocolRequest(out, 0x1234);
    Taken taken = only(out);
    QCOMPARE(taken.type, PackageType::RequestProtocolVersion);
    QCOMPARE(readProtocolRequest(taken.payload).value(), std::uint16_t(0x1234));

    for (const bool accepted : {true, false}) {
        out.clear();
        writeProtocolReply(out, accepted);
        taken = only(out);
        QCOMPARE(readAccepted(taken.payload, taken.type).value(), accepted);
        out.clear();
        writeStartReply(out, accepted);
        taken = only(out);
        QCOMPARE(taken.type, PackageType::Start);
        QCOMPARE(readAccepted(taken.payload, taken.type).value(), accepted);
        out.clear();
        writePauseReply(out, accepted);
        taken = only(out);
        QCOMPARE(taken.type, PackageType::Pause);
        QCOMPARE(readAccepted(taken.payload, taken.type).value(), accepted);
    }

    out.clear();
    writeVersionRequest(out);
    taken = only(out);
    QCOMPARE(taken.type, PackageType::GetUrControlVersion);
    QVERIFY(taken.payload.empty());
    out.clear();
    writeVersionReply(out, {10, 4294967295U, 0, 7});
    const SoftwareVersion expected{10, 4294967295U, 0, 7};
    QVERIFY(readVersionReply(only(out).payload).value() == expected);

    out.clear();
    writeSetupOutputsRequest(out, protocol, 125, names);
    taken = only(out);
    QCOMPARE(taken.type, PackageType::SetupOutputs);
    const auto request = readSetupOutputsRequest(taken.payload, protocol).value();
    QCOMPARE(request.names, names);
    QCOMPARE(request.frequency, version == 1 ? 0.0 : 125.0);

    const std::vector<FieldAnswer> answers{FieldAnswer::of(DataType::Double), FieldAnswer::notFound(),
                                           FieldAnswer::of(DataType::Int32)};
    out.clear();
    writeSetupOutputsReply(out, protocol, 0, answers);
    auto reply = readSetupOutputsReply(only(out).payload, protocol).value();
    QVERIFY(reply.fields == answers);
    QCOMPARE(int(reply.recipeId), 0);

    out.clear();
    writeSetupInputsRequest(out, names);
    taken = only(out);
    QCOMPARE(taken.type, PackageType::SetupInputs);
    QCOMPARE(readSetupInputsRequest(taken.payload).value(), names);
    const std::vector<FieldAnswer> inputs{FieldAnswer::of(DataType::UInt8), FieldAnswer::inUse(),
                                          FieldAnswer::of(DataType::Vector6D)};
    out.clear();
    writeSetupInputsReply(out, 255, inputs);
    reply = readSetupInputsReply(only(out).payload).value();
    QVERIFY(reply.fields == inputs);
    QCOMPARE(int(reply.recipeId), 255);

    std::vector<FieldAnswer> types;
    for (int i = 0; i <= static_cast<int>(DataType::Vector6UInt32); ++i) {
        types.push_back(FieldAnswer::of(static_cast<DataType>(i)));
    }
    out.clear();
    writeSetupOutputsReply(out, protocol, 1, types);
    reply = readSetupOutputsReply(only(out).payload, protocol).value();
    QVERIFY(reply.fields == types);
    QCOMPARE(int(reply.recipeId), 1);
}

void TestCodec::versionOneCarriesNoFrequencyAndNoRecipeId() {
    const std::vector<std::string> names{"timestamp"};
    Bytes out;
    writeSetupOutputsRequest(out, ProtocolVersion::V1, 500, names);
    QCOMPARE(out, withText(bytes({0, 12, 0x4F}), "timestamp"));
    out.clear();
    writeSetupOutputsReply(out, ProtocolVersion::V1, 1, std::array{FieldAnswer::of(DataType::Double)});
    QCOMPARE(out, withText(bytes({0, 9, 0x4F}), "DOUBLE"));

    const ValueLayout layout({DataType::Int32});
    std::array<std::uint8_t, 16> data{};
    QCOMPARE(writeDataPackage(data, std::nullopt, layout, std::array{-2.0}), std::size_t(7));
    const ByteView payload = ByteView(data).subspan(3, 4);
    const auto view = readOutputData(payload, ProtocolVersion::V1);
    QVERIFY(view.has_value());
    double value = 0;
    QVERIFY(decodeValues(layout, view->values, std::span(&value, 1)));
    QCOMPARE(value, -2.0);
}

void TestCodec::textMessagesRoundTripInBothVersions() {
    const TextMessage text{TextLevel::Warning, "watch out", "tiller"};
    for (const auto version : {ProtocolVersion::V1, ProtocolVersion::V2}) {
        Bytes out;
        writeControllerText(out, version, text);
        const Taken taken = only(out);
        QCOMPARE(taken.type, PackageType::TextMessage);
        const auto back = readControllerText(taken.payload, version).value();
        QCOMPARE(back.message, text.message);
        QCOMPARE(back.level, text.level);
        // Version 1 has no field for the source of a message.
        QCOMPARE(back.source, version == ProtocolVersion::V1 ? std::string() : text.source);
    }
    Bytes out;
    writeClientText(out, text);
    QCOMPARE(out, withText(withText(bytes({0, 21, 'M', 9}), "watch out\x06"), "tiller\x02"));
    QVERIFY(readClientText(only(out).payload).value() == text);

    out.clear();
    writeControllerText(out, ProtocolVersion::V1, {TextLevel::Error, "hot", {}});
    QCOMPARE(out, withText(bytes({0, 7, 'M', 1}), "hot"));
}

void TestCodec::longTextsAreTruncated() {
    Bytes out;
    writeClientText(out, {TextLevel::Info, std::string(300, 'a'), std::string(400, 'b')});
    const auto back = readClientText(only(out).payload).value();
    QCOMPARE(back.message, std::string(255, 'a'));
    QCOMPARE(back.source, std::string(255, 'b'));
}

void TestCodec::aTrailingCommaIsNotAField() {
    const std::vector<std::string> names{"timestamp", "actual_q"};
    QCOMPARE(splitNames("timestamp,actual_q,"), names);
    QCOMPARE(splitNames("timestamp,actual_q"), names);
    QVERIFY(splitNames("").empty());
    // An empty name in the middle is a field with an unknown name.
    QCOMPARE(splitNames("a,,b").size(), std::size_t(3));
    QCOMPARE(readSetupInputsReply(withText(bytes({1}), "DOUBLE,")).value().fields.size(), std::size_t(1));
}

void TestCodec::malformedPayloadsGiveAnError_data() {
    QTest::addColumn<QString>("reader");
    QTest::addColumn<QByteArray>("payload");
    const auto row = [](const char* name, const char* reader, const QByteArray& payload) {
        QTest::newRow(name) << QString::fromLatin1(reader) << payload;
    };
    row("protocol request empty", "protocol", {});
    row("protocol request long", "protocol", QByteArray(3, 0));
    row("accepted empty", "accepted", {});
    row("accepted long", "accepted", QByteArray(2, 1));
    row("version short", "version", QByteArray(15, 0));
    row("version long", "version", QByteArray(17, 0));
    row("outputs request without frequency", "outputs request", QByteArray(7, 0));
    row("outputs reply empty", "outputs reply", {});
    row("outputs reply unknown type", "outputs reply", QByteArray("\1DOUBLE,FLOAT"));
    row("outputs reply empty type", "outputs reply", QByteArray("\1DOUBLE,,DOUBLE"));
    row("outputs reply binary", "outputs reply", QByteArray("\1\0\xff\xfe,", 5));
    row("inputs reply empty", "inputs reply", {});
    row("inputs reply lower case", "inputs reply", QByteArray("\1double"));
    row("text empty", "text", {});
    row("text length beyond the end", "text",
        QByteArray("\x05"
                   "abc",
                   4));
    row("text without source", "text",
        QByteArray("\x03"
                   "abc",
                   4));
    row("text source beyond the end", "text",
        QByteArray("\x01"
                   "a\x09"
                   "b",
                   4));
    row("text without level", "text",
        QByteArray("\x01"
                   "a\x01"
                   "b",
                   4));
    row("text with a tail", "text",
        QByteArray("\x01"
                   "a\x01"
                   "b\x03!",
                   6));
    row("text with an unknown level", "text",
        QByteArray("\x01"
                   "a\x01"
                   "b\x04",
                   5));
    row("v1 text empty", "text v1", {});
    row("v1 text with an unknown level", "text v1",
        QByteArray("\x09"
                   "a",
                   2));
}

void TestCodec::malformedPayloadsGiveAnError() {
    QFETCH(QString, reader);
    QFETCH(QByteArray, payload);
    const Bytes copy(payload.begin(), payload.end());
    Error error;
    if (reader == QLatin1String("protocol")) {
        error = readProtocolRequest(copy).error();
    } else if (reader == QLatin1String("accepted")) {
        error = readAccepted(copy, PackageType::Start).error();
    } else if (reader == QLatin1String("version")) {
        error = readVersionReply(copy).error();
    } else if (reader == QLatin1String("outputs request")) {
        error = readSetupOutputsRequest(copy, ProtocolVersion::V2).error();
    } else if (reader == QLatin1String("outputs reply")) {
        error = readSetupOutputsReply(copy, ProtocolVersion::V2).error();
    } else if (reader == QLatin1String("inputs reply")) {
        error = readSetupInputsReply(copy).error();
    } else if (reader == QLatin1String("text")) {
        error = readClientText(copy).error();
        QCOMPARE(readControllerText(copy, ProtocolVersion::V2).error().code, ErrorCode::ProtocolError);
    } else {
        error = readControllerText(copy, ProtocolVersion::V1).error();
    }
    QCOMPARE(error.code, ErrorCode::ProtocolError);
    QVERIFY2(error.context.startsWith(QLatin1String("RTDE_")), qPrintable(error.context));
}

QTEST_GUILESS_MAIN(TestCodec)
#include "tst_codec.moc"
