// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random operator inputs: press, hold for a random time, and end in different ways. In all cases, the arm
// must stop within the limit of the contract and not move before a new press. Three thousand inputs take
// 35 s; TILLER_CAMPAIGN_SEQUENCES=1000 runs ten thousand.

#include <QRandomGenerator>
#include <QTest>

#include "tests/ui/jog_fixture.h"
#include "widgets/jog/jog_selectors.h"
#include "widgets/jog/stop_keys.h"

using namespace tiller;
using namespace tiller::test;

namespace {

// Divided into parts because Qt Test limits the time of a test function.
constexpr int kParts = 10;
constexpr int kSequences = 300;  // per part
constexpr quint32 kSeed = 20261121;
/// Maximum time from the end of holding to standstill [ms]. A window that hangs is detected after 100 ms, and
/// then 250 mm/s decelerate at 2 m/s2.
constexpr int kBoundMs = 250;
/// Permitted distance after the end of holding [mm]: 100 ms at maximum speed, plus the deceleration.
constexpr double kBoundMm = 0.1 * 250 + 0.25 * 0.25 / (2 * 2.0) * 1000 + 3.0;

enum class End {
    Release,
    PointerLeft,
    Escape,
    Space,
    SecondButton,
    WindowDeactivated,
    FocusLost,
    FrozenInterface,
    Disabled
};
constexpr int kEnds = 9;

}  // namespace

class TestJogCampaign : public QObject {
    Q_OBJECT

private:
    static void apply(End end, JogColumn& column, HoldToRunButton& key, VirtualCell& cell) {
        switch (end) {
            case End::Release:
                release(key);
                break;
            case End::PointerLeft:
                sendMouse(key, QEvent::MouseMove, Qt::LeftButton, QPointF(-35, -35));
                break;
            case End::Escape:
                QTest::keyPress(&column, Qt::Key_Escape);
                break;
            case End::Space:
                QTest::keyPress(&column, Qt::Key_Space);
                break;
            case End::SecondButton:
                sendMouse(key, QEvent::MouseButtonPress, Qt::MiddleButton);
                break;
            case End::WindowDeactivated: {
                QEvent event(QEvent::WindowDeactivate);
                QApplication::sendEvent(column.window(), &event);
                break;
            }
            case End::FocusLost: {
                QFocusEvent event(QEvent::FocusOut);
                QApplication::sendEvent(&key, &event);
                break;
            }
            case End::FrozenInterface:
                cell.advanceWithFrozenInterface(300);
                break;
            case End::Disabled:
                key.setEnabled(false);
                key.setEnabled(true);
                break;
        }
    }

private Q_SLOTS:
    void noSequenceMovesBeyondTheBound_data() {
        QTest::addColumn<quint32>("seed");
        for (int part = 0; part < kParts; ++part) {
            QTest::addRow("part %d", part) << kSeed + static_cast<quint32>(part);
        }
    }
    void noSequenceMovesBeyondTheBound() {
        QFETCH(quint32, seed);
        VirtualClock clock;
        RobotSession session(clock);
        VirtualCell cell(clock, session);
        HoldPolicy policy;
        JogColumn column(session, policy);
        StopKeys stopKeys(session, clock);
        column.resize(390, 948);
        column.show();
        QVERIFY(QTest::qWaitForWindowActive(&column));
        QVERIFY2(cell.bringUp(), qPrintable(cell.what()));
        // Updates are disabled, because painting would be most of the cost.
        column.setUpdatesEnabled(false);
        const QVector<HoldToRunButton*> keys = column.holdKeys();
        driveKeys(cell, keys);
        QVector<HoldToRunButton*> jogKeys;
        for (HoldToRunButton* key : keys) {
            // Freedrive needs an external force, which is not simulated here.
            if (key->objectName() != "freedriveKey") {
                jogKeys << key;
            }
        }
        QVERIFY2(jogKeys.size() == 12 + 12 + 3, "expected the pad, the joints, Home, Align and Back");
        // From Home, all buttons can move the arm.
        column.setHome(simulator::kHomeJoints, false);

        QRandomGenerator random(seed);
        int moved = 0;
        bool isGiven = false;
        const int given = qEnvironmentVariableIntValue("TILLER_CAMPAIGN_SEQUENCES", &isGiven);
        const int sequences = isGiven ? given : kSequences;
        for (int sequence = 0; sequence < sequences; ++sequence) {
            column.selectors().setSpeedClass(static_cast<int>(random.bounded(5)));
            HoldToRunButton& key = *jogKeys[random.bounded(jogKeys.size())];
            const auto end = static_cast<End>(random.bounded(kEnds));
            const QString what = QStringLiteral("sequence %1: %2, end %3")
                                     .arg(sequence)
                                     .arg(key.objectName())
                                     .arg(static_cast<int>(end));
            press(key);
            cell.advanceMs(20 + 2 * static_cast<int>(random.bounded(40)));
            moved += standsStill(cell) ? 0 : 1;
            const Pose atEnd = cell.truth().tcpPose;
            apply(end, column, key, cell);
            int ms = end == End::FrozenInterface ? 300 : 0;
            while (ms < 1000 && !standsStill(cell)) {
                cell.advanceMs(2);
                ms += 2;
            }
            QVERIFY2(ms <= (end == End::FrozenInterface ? 300 : kBoundMs),
                     qPrintable(what + ": no standstill"));
            const Pose rest = cell.truth().tcpPose;
            QVERIFY2(distanceMm(atEnd, rest) <= kBoundMm, qPrintable(what + ": too far"));
            // A pointer move on a pressed button is not a new press.
            sendMouse(key, QEvent::MouseMove, Qt::LeftButton, QPointF(10, 10));
            cell.advanceMs(40);
            QVERIFY2(distanceMm(rest, cell.truth().tcpPose) < 0.05, qPrintable(what + ": moved again"));
            release(key);
            QVERIFY2(session.state().control == ControlState::InControl,
                     qPrintable(what + ": " + session.state().controlReason));
        }
        QVERIFY2(moved > sequences / 2,
                 qPrintable(QStringLiteral("only %1 sequences moved the arm").arg(moved)));
    }
};

QTEST_MAIN(TestJogCampaign)
#include "tst_jog_campaign.moc"
