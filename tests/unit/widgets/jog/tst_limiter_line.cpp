// SPDX-License-Identifier: GPL-3.0-or-later
//
// One line shows the limit that stops the arm, and the next line the direction away from it. They are not
// truncated at any column width.
#include <QApplication>
#include <QTest>
#include <numbers>

#include "tests/support/jog_scene.h"
#include "tests/support/live_state.h"
#include "widgets/common/theme.h"
#include "widgets/jog/limiter_line.h"

using namespace tiller;
using namespace tiller::test;

class TestLimiterLine : public QObject {
    Q_OBJECT

private:
    /// Returns one state for each limit that the line can show.
    static QList<QPair<QByteArray, SessionState>> limits() {
        using control::LimiterKind;
        QList<QPair<QByteArray, SessionState>> out;
        for (int joint = 0; joint < kJointCount; ++joint) {
            SessionState state = liveState();
            state.q[joint] = 351 * std::numbers::pi / 180;
            out.append({"range of joint " + QByteArray::number(joint), state});
        }
        for (const LimiterKind kind : {LimiterKind::TcpSpeed, LimiterKind::ElbowSpeed,
                                       LimiterKind::RotationSpeed, LimiterKind::JointSpeed}) {
            SessionState state = liveState();
            state.motionActive = true;
            state.limiter.kind = kind;
            state.limiter.joint = 1;
            state.limiter.scale = 0.35;
            out.append({"speed " + QByteArray::number(static_cast<int>(kind)), state});
        }
        for (const int joint : {0, 2, 4}) {
            SessionState state = liveState();
            state.motionActive = true;
            state.limiter.kind = LimiterKind::Singularity;
            state.limiter.joint = joint;
            state.limiter.scale = 0.35;
            out.append({"singularity " + QByteArray::number(joint), state});
        }
        return out;
    }

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void theEscapeDirectionIsNeverCutOff_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1920x1080") << QSize(390, 948);
        QTest::newRow("1280x720") << QSize(360, 588);
        QTest::newRow("least") << QSize(352, 560);
    }
    void theEscapeDirectionIsNeverCutOff() {
        QFETCH(QSize, size);
        JogScene scene(size);
        auto* line = scene.column.findChild<LimiterLine*>();
        QVERIFY(line != nullptr);
        QCoreApplication::processEvents();
        const int height = line->height();
        QVERIFY(height >= line->minimumSizeHint().height());
        for (const auto& [name, state] : limits()) {
            const LimiterAdvice advice = nearestLimiter(state);
            QVERIFY2(!advice.what.isEmpty() && !advice.advice.isEmpty(), name.constData());
            line->setLimiter(advice);
            QCOMPARE(line->shownLines(), QStringList({advice.what, advice.advice}));
        }
        QCOMPARE(line->height(), height);
    }

    // A refusal ends with the required action.
    void aSentenceIsWrappedNotCutOff() {
        LimiterLine line;
        line.resize(344, 38);
        const QString sentence =
            QStringLiteral("Robot data is late. Waiting for it to come back before it moves.");
        line.setLimiter({sentence, {}});
        QCOMPARE(line.shownLines().size(), 2);
        QCOMPARE(line.shownLines().join(' '), sentence);
        line.setLimiter({QStringLiteral("Let go first."), {}});
        QCOMPARE(line.shownLines(), QStringList(QStringLiteral("Let go first.")));
        line.setLimiter({});
        QVERIFY(line.shownLines().isEmpty());
    }
};

QTEST_MAIN(TestLimiterLine)
#include "tst_limiter_line.moc"
