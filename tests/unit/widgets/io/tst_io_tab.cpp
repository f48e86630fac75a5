// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QTranslator>
#include <memory>

#include "tests/support/sample_stream.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/theme.h"
#include "widgets/io/analog_row.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"

using namespace tiller;
using State = IoChannel::State;

namespace {

SessionState withBits(std::uint64_t inputs, std::uint64_t outputs, LinkState link = LinkState::Live) {
    SessionState state;
    state.link = link;
    state.sequence = 1;
    state.digitalInputs = inputs;
    state.digitalOutputs = outputs;
    return state;
}

/// A language with a long word for "off", such as Spanish.
class LongWord : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char*, const char* source, const char*, int) const override {
        return qstrcmp(source, "off") == 0 ? QStringLiteral("desactivada") : QString();
    }
};

}  // namespace

class TestIoTab : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { applyTheme(*qApp, Theme::light()); }

    void init() {
        asked_.clear();
        clock_ = std::make_unique<VirtualClock>();
        session_ = std::make_unique<RobotSession>();
        session_->shutDown();  // states are set only by the test
        tab_ = std::make_unique<IoTab>(*session_);
        tab_->setClock(*clock_);
        tab_->setOutputSetter([this](int output, bool on) { asked_.append({output, on}); });
        tab_->resize(560, 700);
        tab_->show();
        QVERIFY(QTest::qWaitForWindowExposed(tab_.get()));
    }
    void cleanup() {
        tab_.reset();
        session_.reset();
    }

    void terminalsUseThePrintedNames() {
        QCOMPARE(IoTab::terminal(false, 0), QString("DI 0"));
        QCOMPARE(IoTab::terminal(true, 7), QString("DO 7"));
        QCOMPARE(IoTab::terminal(false, 8), QString("CI 0"));
        QCOMPARE(IoTab::terminal(true, 15), QString("CO 7"));
        QCOMPARE(IoTab::terminal(true, 17), QString("TO 1"));
    }

    void everyBitHasItsRow() {
        for (int channel = 0; channel < IoTab::kChannels; ++channel) {
            feed(withBits(1ULL << channel, 1ULL << (17 - channel)));
            QTRY_VERIFY_WITH_TIMEOUT(tab_->input(channel)->state() == State::On, 60'000);
            for (int other = 0; other < IoTab::kChannels; ++other) {
                QCOMPARE(tab_->input(other)->state() == State::On, other == channel);
                QCOMPARE(tab_->output(other)->state() == State::On, other == 17 - channel);
            }
        }
    }

    void longStateWordsAreNotCut() {
        LongWord words;
        QCoreApplication::installTranslator(&words);
        IoChannel channel(QStringLiteral("DI 0"), false);
        channel.setState(State::Off);
        channel.setStale(false);
        channel.resize(250, IoChannel::kHeight);
        const QImage image = channel.grab().toImage();
        QCoreApplication::removeTranslator(&words);
        for (int x = channel.width() - 4; x < channel.width(); ++x) {
            for (int y = 2; y < channel.height() - 3; ++y) {
                QVERIFY2(image.pixel(x, y) == image.pixel(3, y),
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
            }
        }
    }

    void stateIsShownAsText() {
        feed(withBits(1, 0));
        QTRY_COMPARE_WITH_TIMEOUT(tab_->input(0)->stateWord(), QString("on"), 60'000);
        QCOMPARE(tab_->input(1)->stateWord(), QString("off"));
        QVERIFY(tab_->input(0)->accessibleDescription().contains("on"));
    }

    void aClickAsksAndIsPendingUntilTheRobotConfirms() {
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->output(2)->state() == State::Off, 60'000);
        QTest::mouseClick(tab_->output(2), Qt::LeftButton);
        QCOMPARE(asked_, (QList<std::pair<int, bool>>{{2, true}}));
        QVERIFY(tab_->output(2)->state() == State::PendingOn);
        QCOMPARE(tab_->output(2)->stateWord(), QString("pending…"));
        feed(withBits(0, 0b100));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->output(2)->state() == State::On, 60'000);
        QTest::mouseClick(tab_->output(2), Qt::LeftButton);
        QCOMPARE(asked_.last(), (std::pair<int, bool>{2, false}));
        QVERIFY(tab_->output(2)->state() == State::PendingOff);
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->output(2)->state() == State::Off, 60'000);
    }

    void secondClickRevertsTheFirst() {
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(!tab_->output(0)->isStale(), 60'000);
        QTest::mouseClick(tab_->output(0), Qt::LeftButton);
        QTest::mouseClick(tab_->output(0), Qt::LeftButton);
        QCOMPARE(asked_, (QList<std::pair<int, bool>>{{0, true}, {0, false}}));
    }

    void missingConfirmationIsReported() {
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(!tab_->output(16)->isStale(), 60'000);
        QTest::mouseClick(tab_->output(16), Qt::LeftButton);
        auto* notice = tab_->findChild<NoticeBar*>("io.notice");
        const QPoint place = tab_->output(16)->mapTo(tab_.get(), QPoint(0, 0));
        clock_->advanceNs(1900 * kNsPerMs);
        feed(withBits(1, 0));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->input(0)->state() == State::On,
                                 60'000);  // the tab has received the state
        QVERIFY(tab_->output(16)->state() == State::PendingOn);
        clock_->advanceNs(200 * kNsPerMs);
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->output(16)->state() == State::Off, 60'000);
        QVERIFY(notice->isVisible());
        QVERIFY(notice->title().contains("TO 0"));
        QTest::qWait(1);
        QCOMPARE(tab_->output(16)->mapTo(tab_.get(), QPoint(0, 0)), place);
        QVERIFY(tab_->rect().contains(notice->geometry()));
    }

    void oldDataAreGreyAndCannotBeSwitched() {
        feed(withBits(1, 1));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->output(0)->state() == State::On, 60'000);
        feed(withBits(1, 1, LinkState::Stale));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->input(0)->isStale(), 60'000);
        QVERIFY(tab_->input(0)->state() == State::On);
        QVERIFY(tab_->output(0)->isStale());
        QTest::mouseClick(tab_->output(0), Qt::LeftButton);
        QVERIFY(asked_.isEmpty());
        feed(withBits(1, 1, LinkState::Lost));
        QTRY_COMPARE_WITH_TIMEOUT(tab_->input(0)->stateWord(), QString("no data"), 60'000);
    }

    // The analog values belong to the same sample as the bits, not to a newer sample.
    void analogValuesMatchTheShownSample() {
        test::SampleStream stream;
        stream.set(stream.add(1.0, 1), "standard_analog_input0", 12);
        stream.frame([this](const SampleBatch& batch) { Q_EMIT session_->samplesReceived(batch); });
        feed(withBits(1, 0));
        QTRY_COMPARE_WITH_TIMEOUT(tab_->input(0)->stateWord(), QString("on"), 60'000);
        QVERIFY2(tab_->analogInput(0)->valueText().startsWith("12"),
                 qPrintable(tab_->analogInput(0)->valueText()));
        Q_EMIT session_->linkBegan();  // another robot, from which no sample has arrived yet
        feed(withBits(0, 0));
        QTRY_COMPARE_WITH_TIMEOUT(tab_->input(0)->stateWord(), QString("off"), 60'000);
        QVERIFY2(!tab_->analogInput(0)->valueText().contains("12"),
                 qPrintable(tab_->analogInput(0)->valueText()));
    }

    void inputsCannotBeSwitched() {
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(tab_->input(0)->state() == State::Off, 60'000);
        QTest::mouseClick(tab_->input(0), Qt::LeftButton);
        QVERIFY(asked_.isEmpty());
    }

    void enterSwitchesButSpaceDoesNot() {
        feed(withBits(0, 0));
        QTRY_VERIFY_WITH_TIMEOUT(!tab_->output(1)->isStale(), 60'000);
        tab_->output(1)->setFocus();
        QTest::keyClick(tab_->output(1), Qt::Key_Space);
        QVERIFY(asked_.isEmpty());
        QTest::keyClick(tab_->output(1), Qt::Key_Return);
        QCOMPARE(asked_.size(), 1);
    }

    void namesAreEditedInPlaceAndSaved() {
        QSignalSpy changed(tab_.get(), &IoTab::namesChanged);
        tab_->output(0)->rename();
        auto* editor = tab_->output(0)->findChild<QLineEdit*>();
        QTest::keyClicks(editor, "gripper");
        QTest::keyClick(editor, Qt::Key_Return);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(tab_->names(), (QMap<QString, QString>{{"DO 0", "gripper"}}));
        QCOMPARE(tab_->output(0)->accessibleName(), QString("DO 0, gripper"));
        tab_->setNames({{"TI 1", "part present"}});
        QCOMPARE(tab_->input(17)->name(), QString("part present"));
        QVERIFY(tab_->output(0)->name().isEmpty());
    }

    // If the row did not take the focus back, the next widget of the window would get it, such as the robot
    // selector in the header.
    void theFocusStaysInTheRowAfterRenaming() {
        tab_->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(tab_.get()));
        for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Escape}) {
            tab_->output(3)->setFocus();
            tab_->output(3)->rename();
            auto* editor = tab_->output(3)->findChild<QLineEdit*>();
            QVERIFY(editor->hasFocus());
            QTest::keyClicks(editor, "valve");
            QTest::keyClick(editor, key);
            QVERIFY(!editor->isVisible());
            QVERIFY2(tab_->output(3)->hasFocus(), qPrintable(QString::number(key)));
        }
        QCOMPARE(tab_->output(3)->name(), QString("valve"));
        // A click elsewhere ends the editing as well, and takes the focus.
        tab_->output(3)->rename();
        tab_->output(5)->setFocus(Qt::MouseFocusReason);
        QVERIFY(tab_->output(5)->hasFocus());
    }

private:
    void feed(const SessionState& state) { Q_EMIT session_->stateChanged(state); }

    QList<std::pair<int, bool>> asked_;
    std::unique_ptr<VirtualClock> clock_;
    std::unique_ptr<RobotSession> session_;
    std::unique_ptr<IoTab> tab_;
};

QTEST_MAIN(TestIoTab)
#include "tst_io_tab.moc"
