// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <deque>

#include "robot/station/route/hold_to_run_sequence.h"

using namespace tiller;
using control::StopCause;
using State = SequenceStep::State;

namespace {

/// Calls received by the steps, in order.
using Notes = QStringList;

class NotedStep : public SequenceStep {
public:
    NotedStep(Notes& notes, QString name, int turns, State last, Error refusal)
        : notes_(notes), name_(std::move(name)), turns_(turns), last_(last), refusal_(std::move(refusal)) {}

    Result<void> begin(std::uint64_t stops) override {
        notes_ << QStringLiteral("begin %1 after %2").arg(name_).arg(stops);
        return refusal_.code == ErrorCode::None ? Result<void>() : refusal_;
    }
    Result<State> hold() override { return turns_-- > 0 ? State::Going : last_; }
    void end(StopCause cause) override {
        notes_ << QStringLiteral("end %1 by %2").arg(name_).arg(static_cast<int>(cause));
    }

private:
    Notes& notes_;
    QString name_;
    int turns_;
    State last_;
    Error refusal_;
};

struct Bench {
    struct Planned {
        QString name;
        int turns = 1;
        State last = State::Done;
        Error refusal = {};
    };
    Notes notes;
    std::deque<Planned> planned;
    std::uint64_t stops = 7;
    QList<ErrorCode> failures;
    HoldToRunSequence sequence{[this] { return stops; },
                               [this]() -> Result<std::unique_ptr<SequenceStep>> {
                                   if (planned.empty()) {
                                       return std::unique_ptr<SequenceStep>();
                                   }
                                   const Planned next = planned.front();
                                   planned.pop_front();
                                   return std::unique_ptr<SequenceStep>(std::make_unique<NotedStep>(
                                       notes, next.name, next.turns, next.last, next.refusal));
                               },
                               [this](const Error& error) { failures << error.code; }};
    HoldMotion motion{sequence.motion({})};
};

}  // namespace

class TestHoldToRunSequence : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void stepsRunInSequenceUntilAllAreDone() {
        Bench b;
        b.planned = {{"a"}, {"b", 2}};
        const auto id = b.motion.begin();
        QVERIFY(id.ok());
        QCOMPARE(b.notes, Notes{"begin a after 7"});
        QVERIFY(b.motion.hold(*id));
        QVERIFY(b.motion.hold(*id));  // `a` is complete, and `b` begins in the same cycle
        QCOMPARE(b.notes, (Notes{"begin a after 7", "begin b after 7"}));
        QVERIFY(b.motion.hold(*id) && b.motion.hold(*id));
        QVERIFY(!b.motion.hold(*id));
        QVERIFY(!b.sequence.isActive());
        QVERIFY(b.failures.isEmpty());
    }

    void releaseEndsTheCurrentStepAndStartsNoOther() {
        Bench b;
        b.planned = {{"a"}, {"b"}};
        const auto id = b.motion.begin();
        b.motion.end(*id, StopCause::Released);
        QCOMPARE(b.notes,
                 (Notes{"begin a after 7", QStringLiteral("end a by %1").arg(int(StopCause::Released))}));
        QVERIFY(!b.motion.hold(*id));
        QCOMPARE(b.planned.size(), std::size_t(1));
    }

    // A stop during a pause between two motions finds no motion to stop. The next motion must not begin
    // either.
    void aStopBetweenTwoStepsEndsTheSequence() {
        Bench b;
        b.planned = {{"wait", 100}, {"b"}};
        const auto id = b.motion.begin();
        QVERIFY(b.motion.hold(*id));
        ++b.stops;
        QVERIFY(!b.motion.hold(*id));
        QVERIFY(b.notes.last().startsWith("end wait"));
        QCOMPARE(b.planned.size(), std::size_t(1));
        QVERIFY(b.failures.isEmpty());
    }

    void anInterruptedStepEndsTheSequence() {
        Bench b;
        b.planned = {{"a", 0, State::Ended}, {"b"}};
        const auto id = b.motion.begin();
        QVERIFY(!b.motion.hold(*id));
        QCOMPARE(b.planned.size(), std::size_t(1));
        QVERIFY(!b.motion.hold(*id));
    }

    void aStepThatCannotStartIsReportedAndEndsTheSequence() {
        Bench b;
        b.planned = {{"a", 0}, {"b", 0, State::Done, {ErrorCode::NoSolution, "out of reach", {}}}};
        const auto id = b.motion.begin();
        QVERIFY(!b.motion.hold(*id));
        QCOMPARE(b.failures, QList<ErrorCode>{ErrorCode::NoSolution});
        QVERIFY(!b.sequence.isActive());

        Bench first;
        first.planned = {{"a", 0, State::Done, {ErrorCode::NotInControl, {}, {}}}};
        QVERIFY(!first.motion.begin().ok());
        QVERIFY2(first.failures.isEmpty(), "the failure was reported twice");
    }

    void anEarlierStopIsNotReportedAsAFailure() {
        Bench b;
        b.planned = {{"a", 0}, {"b", 0, State::Done, {ErrorCode::Stopped, {}, {}}}};
        const auto id = b.motion.begin();
        QVERIFY(!b.motion.hold(*id));
        QVERIFY(b.failures.isEmpty());
    }

    void anOldMotionIdMovesNothing() {
        Bench b;
        b.planned = {{"a"}, {"b"}};
        const auto first = b.motion.begin();
        b.motion.end(*first, StopCause::Escape);
        const auto second = b.motion.begin();
        QVERIFY(!b.motion.hold(*first));
        b.motion.end(*first, StopCause::Escape);
        QVERIFY(b.sequence.isActive());
        QVERIFY(b.motion.hold(*second));
    }
};

QTEST_APPLESS_MAIN(TestHoldToRunSequence)
#include "tst_hold_to_run_sequence.moc"
