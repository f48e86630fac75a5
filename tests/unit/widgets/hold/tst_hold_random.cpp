// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand random sequences of presses, releases, focus changes, keys, windows and stalls, in virtual time.
// In all cases, the arm moves only while a button is held, and a stopped motion never moves the arm again.
#include <QApplication>
#include <QDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QRandomGenerator>
#include <QSet>
#include <QTest>
#include <memory>

#include "robot/core/clock.h"
#include "widgets/hold/hold_to_run_button.h"

using namespace tiller;
using control::StopCause;

namespace {

constexpr std::int64_t kExpiryNs = 100 * kNsPerMs;

/// A session that follows the contract: it has one motion slot, and a motion expires 100 ms after its last
/// refresh.
struct ExpiringSession {
    explicit ExpiringSession(const Clock& clock_) : clock(clock_) {}

    const Clock& clock;
    std::uint64_t next = 0;
    std::uint64_t running = 0;
    std::int64_t refreshedNs = 0;
    QSet<std::uint64_t> stopped;
    bool broken = false;  // a stopped motion was refreshed or ended again

    bool moving() const { return running != 0 && clock.nowNs() - refreshedNs <= kExpiryNs; }

    HoldMotion motion() {
        return {.begin = [this]() -> Result<HoldMotion::Id> {
                    if (running != 0) {
                        stopped.insert(running);
                    }
                    running = ++next;
                    refreshedNs = clock.nowNs();
                    return running;
                },
                .hold =
                    [this](HoldMotion::Id id) {
                        if (id != running || clock.nowNs() - refreshedNs > kExpiryNs) {
                            stopped.insert(id);
                            running = id == running ? 0 : running;
                            return false;
                        }
                        broken = broken || stopped.contains(id);
                        refreshedNs = clock.nowNs();
                        return true;
                    },
                .end =
                    [this](HoldMotion::Id id, StopCause cause) {
                        broken = broken || stopped.contains(id) || cause == StopCause::None;
                        stopped.insert(id);
                        running = id == running ? 0 : running;
                    },
                .runsToEnd = {}};
    }
};

}  // namespace

class TestHoldRandom : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void nothingMovesUnlessOneKeyIsHeld() {
        VirtualClock clock;
        ExpiringSession session(clock);
        HoldPolicy policy;
        QWidget window;
        auto* layout = new QHBoxLayout(&window);
        layout->setContentsMargins(50, 50, 50, 50);
        std::array<HoldToRunButton*, 2> keys{};
        for (auto& key : keys) {
            key = new HoldToRunButton(QStringLiteral("X+"), policy, &window);
            key->setFixedSize(80, 60);
            key->guard().setClock(clock);
            key->setMotion(session.motion());
            layout->addWidget(key);
        }
        auto* edit = new QLineEdit(&window);
        layout->addWidget(edit);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));

        QRandomGenerator random(20261121);
        int motions = 0;
        for (int sequence = 0; sequence < 1000; ++sequence) {
            // The button that may move the arm according to the model: the last one pressed, until an event
            // interrupts it.
            int held = -1;
            int pressed = -1;  // the button that the left mouse button holds down
            const int length = 2 + static_cast<int>(random.bounded(12U));
            for (int step = 0; step < length; ++step) {
                const auto action = random.bounded(12U);
                const auto which = static_cast<int>(random.bounded(2U));
                HoldToRunButton* key = keys.at(static_cast<std::size_t>(which));
                switch (action) {
                    case 0:
                    case 1:
                    case 2:
                        if (pressed < 0) {
                            QTest::mousePress(key, Qt::LeftButton);
                            pressed = held = which;
                            ++motions;
                        }
                        break;
                    case 3:
                        if (pressed >= 0) {
                            QTest::mouseRelease(keys.at(static_cast<std::size_t>(pressed)), Qt::LeftButton);
                            pressed = held = -1;
                        }
                        break;
                    case 4:
                        edit->setFocus();
                        held = -1;
                        break;
                    case 5:
                        QTest::keyPress(&window, random.bounded(2U) == 0 ? Qt::Key_Escape : Qt::Key_Space);
                        held = -1;
                        break;
                    case 6:
                        if (pressed >= 0) {
                            QTest::mouseMove(keys.at(static_cast<std::size_t>(pressed)), QPoint(-200, 30));
                            held = -1;
                        }
                        break;
                    case 7: {
                        QDialog dialog(&window);
                        dialog.show();
                        held = -1;
                        dialog.hide();
                        break;
                    }
                    case 8:  // the event loop is blocked
                        clock.advanceNs(150 * kNsPerMs);
                        held = -1;
                        break;
                    case 9:
                        keys[0]->setUnavailable(QStringLiteral("Protective stop"));
                        keys[1]->setUnavailable(QStringLiteral("Protective stop"));
                        held = -1;
                        keys[0]->setUnavailable({});
                        keys[1]->setUnavailable({});
                        break;
                    case 10:
                        QTest::mousePress(key, Qt::RightButton);
                        QTest::mouseRelease(key, Qt::RightButton);
                        held = -1;
                        break;
                    default:
                        break;
                }
                clock.advanceNs(20 * kNsPerMs);
                for (HoldToRunButton* each : keys) {
                    each->guard().pump();
                }
                const QByteArray where = QByteArray("sequence ") + QByteArray::number(sequence) + " step " +
                                         QByteArray::number(step) + " action " + QByteArray::number(action);
                QVERIFY2(!session.broken, where.constData());
                QVERIFY2(session.moving() == (held >= 0), where.constData());
                for (int i = 0; i < 2; ++i) {
                    QVERIFY2(keys.at(static_cast<std::size_t>(i))->isHolding() == (i == held),
                             where.constData());
                }
            }
            if (pressed >= 0) {
                QTest::mouseRelease(keys.at(static_cast<std::size_t>(pressed)), Qt::LeftButton);
            }
            QVERIFY(!session.moving());
            window.activateWindow();
        }
        QVERIFY(motions > 500);
    }
};

QTEST_MAIN(TestHoldRandom)
#include "tst_hold_random.moc"
