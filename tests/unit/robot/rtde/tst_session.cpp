// SPDX-License-Identifier: MIT
#include <QTest>
#include <array>
#include <cmath>

#include "robot/rtde/fields.h"
#include "robot/rtde/session.h"

using namespace tiller;
using namespace tiller::rtde;

namespace {

/// Feeds data to a session and records its requests.
struct Talk {
    explicit Talk(SessionRequest request) : session(std::move(request)) { session.begin(sent); }

    Session session;
    Bytes sent;

    /// Removes the pending request and returns its type.
    PackageType asked() {
        PackageSplitter splitter;
        splitter.feed(sent);
        const auto package = splitter.next();
        if (!package) {
            return PackageType{};
        }
        payload.assign(package->payload.begin(), package->payload.end());
        const bool more = splitter.next().has_value();
        sent.clear();
        return more ? PackageType{} : package->type;
    }
    template <class Write>
    void answer(Write write) {
        Bytes bytes;
        write(bytes);
        PackageSplitter splitter;
        splitter.feed(bytes);
        while (const auto package = splitter.next()) {
            session.handle(*package, sent);
        }
    }
    void acceptProtocol(bool accepted = true) {
        answer([&](Bytes& out) { writeProtocolReply(out, accepted); });
    }
    void giveVersion(SoftwareVersion version = {5, 22, 1, 0}) {
        answer([&](Bytes& out) { writeVersionReply(out, version); });
    }
    void giveOutputs(std::uint8_t id, const std::vector<FieldAnswer>& fields) {
        answer([&](Bytes& out) { writeSetupOutputsReply(out, session.protocol(), id, fields); });
    }
    void giveInputs(std::uint8_t id, const std::vector<FieldAnswer>& fields) {
        answer([&](Bytes& out) { writeSetupInputsReply(out, id, fields); });
    }
    void acceptStart(bool accepted = true) {
        answer([&](Bytes& out) { writeStartReply(out, accepted); });
    }
    std::vector<std::string> outputNames() {
        return readSetupOutputsRequest(payload, session.protocol()).value().names;
    }

    Bytes payload;  ///< payload of the last request returned by asked()
};

SessionRequest outputs(std::vector<std::string> names, double frequency = 0) {
    SessionRequest request;
    request.outputs = std::move(names);
    request.frequency = frequency;
    return request;
}

const FieldAnswer kDouble = FieldAnswer::of(DataType::Double);
const FieldAnswer kVector = FieldAnswer::of(DataType::Vector6D);

}  // namespace

class TestSession : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void handshakeIsInOrder();
    void fallsBackToVersionOne();
    void requestsOfferedFields();
    void dropsUnknownOutputsAndAsksAgain();
    void failsWhenNoOutputIsKnown();
    void usesTheTypesReportedByTheRobot();
    void dropsUnknownInputsAndAsksAgain();
    void inputsInUseEndTheSessionAndAreReported();
    void inputsInUseMayBeTolerated();
    void unknownInputsAloneAreNotAnError();
    void inputsAloneNeedNoStart();
    void textMessagesMayArriveAtAnyTime();
    void dataBeforeTheReplyToStartAreAccepted();
    void refusedStartIsAnError();
    void pausesAndResumes();
    void unsolicitedRepliesAreIgnored();
    void wrongCountsAndGarbageAreErrors();
    void excessivelyLongListsAreRefusedImmediately();
};

void TestSession::handshakeIsInOrder() {
    SessionRequest request = outputs({"timestamp", "actual_q"}, 500);
    request.inputs.push_back({{"speed_slider_mask", "speed_slider_fraction"}, true});
    Talk talk(request);
    QCOMPARE(talk.asked(), PackageType::RequestProtocolVersion);
    QCOMPARE(readProtocolRequest(talk.payload).value(), std::uint16_t(2));
    talk.acceptProtocol();
    QCOMPARE(talk.asked(), PackageType::GetUrControlVersion);
    talk.giveVersion();
    QCOMPARE(talk.asked(), PackageType::SetupOutputs);
    QCOMPARE(talk.outputNames(), request.outputs);
    talk.giveOutputs(1, {kDouble, kVector});
    QCOMPARE(talk.asked(), PackageType::SetupInputs);
    talk.giveInputs(7, {FieldAnswer::of(DataType::UInt32), kDouble});
    QCOMPARE(talk.asked(), PackageType::Start);
    QVERIFY(!talk.session.isReady());
    talk.acceptStart();
    QCOMPARE(talk.session.state(), Session::State::Running);
    QVERIFY(talk.sent.empty());

    QVERIFY((talk.session.version() == SoftwareVersion{5, 22, 1, 0}));
    QCOMPARE(talk.session.outputs().size(), std::size_t(7));
    QCOMPARE(talk.session.outputs().indexOf("actual_q").value(), std::size_t(1));
    QCOMPARE(int(talk.session.inputs().at(0).id()), 7);
    QCOMPARE(talk.session.period(), 0.002);
}

void TestSession::fallsBackToVersionOne() {
    Talk talk(outputs({"timestamp"}, 50));
    talk.asked();
    talk.acceptProtocol(false);
    QCOMPARE(talk.asked(), PackageType::RequestProtocolVersion);
    QCOMPARE(readProtocolRequest(talk.payload).value(), std::uint16_t(1));
    talk.acceptProtocol();
    QCOMPARE(talk.session.protocol(), ProtocolVersion::V1);
    talk.asked();
    talk.giveVersion({3, 3, 4, 0});
    QCOMPARE(talk.asked(), PackageType::SetupOutputs);
    QCOMPARE(QByteArray(reinterpret_cast<const char*>(talk.payload.data()), 9), QByteArray("timestamp"));
    talk.giveOutputs(1, {kDouble});
    talk.asked();
    talk.acceptStart();
    QCOMPARE(talk.session.state(), Session::State::Running);
    // Version 1 cannot request a lower rate.
    QCOMPARE(talk.session.period(), 0.008);
}

void TestSession::requestsOfferedFields() {
    struct Case {
        double wanted;
        SoftwareVersion version;
        double asked;
        double period;
    };
    const Case cases[] = {
        {0, {5, 0, 0, 0}, 500, 0.002},    {0, {3, 15, 0, 0}, 125, 0.008},
        {0, {10, 11, 0, 0}, 500, 0.002},  {500, {3, 15, 0, 0}, 125, 0.008},
        {125, {5, 22, 0, 0}, 125, 0.008}, {200, {5, 22, 0, 0}, 200, 0.004},
        {1e9, {5, 22, 0, 0}, 500, 0.002}, {0.1, {5, 22, 0, 0}, 1, 1.0},
        {-5, {5, 22, 0, 0}, 500, 0.002},  {std::nan(""), {5, 0, 0, 0}, 500, 0.002},
    };
    for (const Case& c : cases) {
        Talk talk(outputs({"timestamp"}, c.wanted));
        talk.acceptProtocol();
        talk.sent.clear();
        talk.giveVersion(c.version);
        QCOMPARE(talk.asked(), PackageType::SetupOutputs);
        QCOMPARE(readSetupOutputsRequest(talk.payload, ProtocolVersion::V2).value().frequency, c.asked);
        QCOMPARE(talk.session.period(), c.period);
    }
}

void TestSession::dropsUnknownOutputsAndAsksAgain() {
    Talk talk(outputs({"timestamp", "nonsense", "actual_q", "ft_raw_wrench"}));
    talk.acceptProtocol();
    talk.giveVersion();
    talk.sent.clear();
    talk.giveOutputs(0, {kDouble, FieldAnswer::notFound(), kVector, FieldAnswer::notFound()});
    QCOMPARE(talk.asked(), PackageType::SetupOutputs);
    QCOMPARE(talk.outputNames(), (std::vector<std::string>{"timestamp", "actual_q"}));
    talk.giveOutputs(1, {kDouble, kVector});
    QCOMPARE(talk.asked(), PackageType::Start);
    QCOMPARE(talk.session.outputs().absent(), (std::vector<std::string>{"nonsense", "ft_raw_wrench"}));
    QVERIFY(!talk.session.outputs().has("nonsense"));
    QVERIFY(!talk.session.outputs().indexOf("ft_raw_wrench").has_value());
}

void TestSession::failsWhenNoOutputIsKnown() {
    Talk talk(outputs({"a", "b"}));
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveOutputs(0, {FieldAnswer::notFound(), FieldAnswer::notFound()});
    QCOMPARE(talk.session.error().code, ErrorCode::FieldUnknown);
    QVERIFY(talk.session.error().context.contains(QLatin1String("a, b")));
}

void TestSession::usesTheTypesReportedByTheRobot() {
    Talk talk(outputs({"timestamp", "actual_q"}));
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveOutputs(1, {FieldAnswer::of(DataType::UInt64), FieldAnswer::of(DataType::Vector3D)});
    QCOMPARE(talk.session.outputs().find("actual_q")->type, DataType::Vector3D);
    QCOMPARE(talk.session.outputs().size(), std::size_t(4));
}

void TestSession::dropsUnknownInputsAndAsksAgain() {
    SessionRequest request;
    request.inputs.push_back({{"tool_digital_output_mask", "speed_slider_mask"}, true});
    Talk talk(request);
    talk.acceptProtocol();
    talk.giveVersion();
    talk.sent.clear();
    talk.giveInputs(0, {FieldAnswer::notFound(), FieldAnswer::of(DataType::UInt32)});
    QCOMPARE(talk.asked(), PackageType::SetupInputs);
    QCOMPARE(readSetupInputsRequest(talk.payload).value(), std::vector<std::string>{"speed_slider_mask"});
    talk.giveInputs(2, {FieldAnswer::of(DataType::UInt32)});
    QCOMPARE(talk.session.state(), Session::State::Ready);
    QCOMPARE(int(talk.session.inputs().at(0).id()), 2);
    QCOMPARE(talk.session.inputs().at(0).absent(), std::vector<std::string>{"tool_digital_output_mask"});
}

void TestSession::inputsInUseEndTheSessionAndAreReported() {
    SessionRequest request;
    request.inputs.push_back({{"input_int_register_0", "input_int_register_1", "speed_slider_mask"}, true});
    Talk talk(request);
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveInputs(0, {FieldAnswer::inUse(), FieldAnswer::inUse(), FieldAnswer::of(DataType::UInt32)});
    QVERIFY(talk.session.isFailed());
    QCOMPARE(talk.session.error().code, ErrorCode::RegisterInUse);
    QVERIFY(
        talk.session.error().context.contains(QLatin1String("input_int_register_0, input_int_register_1")));
    QVERIFY(!talk.session.error().context.contains(QLatin1String("speed_slider_mask")));
}

void TestSession::inputsInUseMayBeTolerated() {
    SessionRequest request;
    request.inputs.push_back({{"speed_slider_mask"}, false});
    request.inputs.push_back({{"standard_digital_output_mask"}, false});
    Talk talk(request);
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveInputs(0, {FieldAnswer::inUse()});
    talk.giveInputs(1, {FieldAnswer::of(DataType::UInt8)});
    QCOMPARE(talk.session.state(), Session::State::Ready);
    QVERIFY(!talk.session.inputs().at(0).isValid());
    QVERIFY(talk.session.inputs().at(1).isValid());
    QCOMPARE(talk.session.inUse().at(0), std::vector<std::string>{"speed_slider_mask"});
    QVERIFY(talk.session.inUse().at(1).empty());
}

void TestSession::unknownInputsAloneAreNotAnError() {
    SessionRequest request;
    request.inputs.push_back({{"input_int_register_24"}, true});
    Talk talk(request);
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveInputs(0, {FieldAnswer::notFound()});
    QCOMPARE(talk.session.state(), Session::State::Ready);
    QVERIFY(!talk.session.inputs().at(0).isValid());
    QCOMPARE(talk.session.inputs().at(0).absent(), std::vector<std::string>{"input_int_register_24"});
}

void TestSession::inputsAloneNeedNoStart() {
    SessionRequest request;
    request.inputs.push_back({{"speed_slider_mask"}, true});
    Talk talk(request);
    talk.acceptProtocol();
    talk.giveVersion();
    talk.sent.clear();
    talk.giveInputs(1, {FieldAnswer::of(DataType::UInt32)});
    QCOMPARE(talk.session.state(), Session::State::Ready);
    QVERIFY(talk.sent.empty());
}

void TestSession::textMessagesMayArriveAtAnyTime() {
    Talk talk(outputs({"timestamp"}));
    const auto text = [&](const char* words) {
        talk.answer([&](Bytes& out) {
            writeControllerText(out, talk.session.protocol(), {TextLevel::Warning, words, ""});
        });
    };
    text("one");
    talk.acceptProtocol();
    text("two");
    talk.giveVersion();
    text("three");
    // A version 1 text message after version 2 was negotiated.
    talk.answer([&](Bytes& out) {
        writeControllerText(out, ProtocolVersion::V1, {TextLevel::Info, "x", ""});
    });
    talk.giveOutputs(1, {kDouble});
    text("four");
    talk.acceptStart();
    QCOMPARE(talk.session.state(), Session::State::Running);
    QCOMPARE(talk.session.texts().size(), std::size_t(5));
    QCOMPARE(talk.session.texts().front().message, std::string("one"));
    for (int i = 0; i < 100; ++i) {
        text("again");
    }
    QCOMPARE(talk.session.texts().size(), std::size_t(32));
}

void TestSession::dataBeforeTheReplyToStartAreAccepted() {
    Talk talk(outputs({"timestamp"}));
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveOutputs(1, {kDouble});
    QCOMPARE(talk.session.state(), Session::State::Starting);
    talk.session.handle({PackageType::Data, {}}, talk.sent);
    QCOMPARE(talk.session.state(), Session::State::Running);
    talk.acceptStart();
    QCOMPARE(talk.session.state(), Session::State::Running);
}

void TestSession::refusedStartIsAnError() {
    Talk talk(outputs({"timestamp"}));
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveOutputs(1, {kDouble});
    talk.acceptStart(false);
    QCOMPARE(talk.session.error().code, ErrorCode::Rejected);
}

void TestSession::pausesAndResumes() {
    Talk talk(outputs({"timestamp"}));
    talk.acceptProtocol();
    talk.giveVersion();
    talk.giveOutputs(1, {kDouble});
    talk.acceptStart();
    talk.sent.clear();
    talk.session.pause(talk.sent);
    QCOMPARE(talk.asked(), PackageType::Pause);
    // Data that were still in transit.
    talk.session.handle({PackageType::Data, {}}, talk.sent);
    QCOMPARE(talk.session.state(), Session::State::Pausing);
    talk.answer([](Bytes& out) { writePauseReply(out, true); });
    QCOMPARE(talk.session.state(), Session::State::Ready);
    talk.session.start(talk.sent);
    QCOMPARE(talk.asked(), PackageType::Start);
    talk.acceptStart();
    QCOMPARE(talk.session.state(), Session::State::Running);
}

void TestSession::unsolicitedRepliesAreIgnored() {
    Talk talk(outputs({"timestamp"}));
    talk.sent.clear();
    talk.giveVersion();
    talk.acceptStart();
    talk.answer([](Bytes& out) { writePauseReply(out, true); });
    talk.session.handle({static_cast<PackageType>('?'), {}}, talk.sent);
    QCOMPARE(talk.session.state(), Session::State::AskingProtocol);
    QVERIFY(talk.sent.empty());
}

void TestSession::wrongCountsAndGarbageAreErrors() {
    {
        Talk talk(outputs({"timestamp", "actual_q"}));
        talk.acceptProtocol();
        talk.giveVersion();
        talk.giveOutputs(1, {kDouble});
        QCOMPARE(talk.session.error().code, ErrorCode::ProtocolError);
    }
    {
        Talk talk(outputs({"timestamp"}));
        talk.session.handle({PackageType::RequestProtocolVersion, {}}, talk.sent);
        QCOMPARE(talk.session.error().code, ErrorCode::ProtocolError);
    }
    {
        // The reply contains no recipe, although all types are known.
        Talk talk(outputs({"timestamp"}));
        talk.acceptProtocol();
        talk.giveVersion();
        talk.giveOutputs(0, {kDouble});
        QCOMPARE(talk.session.error().code, ErrorCode::Rejected);
        // A failed session stays failed, even after a valid reply.
        talk.sent.clear();
        talk.giveOutputs(1, {kDouble});
        QVERIFY(talk.session.isFailed());
        QVERIFY(talk.sent.empty());
    }
}

void TestSession::excessivelyLongListsAreRefusedImmediately() {
    std::vector<std::string> names;
    for (const Field& field : outputFields()) {
        names.push_back(field.name);
    }
    Talk talk(outputs(names));
    QCOMPARE(talk.session.error().code, ErrorCode::InvalidArgument);
    QVERIFY(talk.sent.empty());
}

QTEST_GUILESS_MAIN(TestSession)
#include "tst_session.moc"
