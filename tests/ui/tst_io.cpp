// SPDX-License-Identifier: GPL-3.0-or-later
//
// The I/O tab in the real window, with real sockets and the simulated robot in virtual time.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTcpSocket>
#include <QTest>

#include "resources/resources.h"
#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/window_bench.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/notice_bar.h"
#include "widgets/io/analog_row.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"
#include "widgets/io/register_panel.h"

using namespace tiller;
using namespace tiller::test;

class TestIo : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;

    VirtualCell& cell() { return bench_->cell; }
    IoTab& tab() { return *bench_->window.findChild<IoTab*>(); }
    template <class Widget>
    Widget& find(const char* name) {
        return bench_->find<Widget>(name);
    }
    /// Also waits in real time, because a worker thread sends the settings.
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell(), condition); }
    bool output(int number) { return (cell().truth().digitalOutputs >> number & 1) != 0; }

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        bench_ = std::make_unique<WindowBench>();
        bench_->window.setTheme("light");
        bench_->window.show();
        bench_->window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench_->window));
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        driveKeys(cell(), bench_->window.jogColumn().holdKeys());
        bench_->window.showTab("io");
        QVERIFY(until([this] { return !tab().output(0)->isStale(); }));
    }
    void cleanup() { bench_.reset(); }

    void settingAnOutputStopsNoProgramAndNoMove() {
        // A move to Home takes longer than the test needs and uses the control program of the window.
        press(find<HoldToRunButton>("homeKey"));
        cell().advanceMs(300);
        QVERIFY(!standsStill(cell()));
        bench_->window.session().outputs().setDigitalOutput(2, true);
        QVERIFY(until([this] { return output(2); }));
        QVERIFY2(!standsStill(cell()), "setting an output stopped the arm");
        QVERIFY(find<HoldToRunButton>("homeKey").isHolding());
        QCOMPARE(cell().truth().runtimeState, RuntimeState::Playing);
        release(find<HoldToRunButton>("homeKey"));
        cell().advanceMs(400);
        // Switch the output manually while the program is idle. The session must stay in control.
        tab().output(3)->click();
        QVERIFY(until([this] { return output(3); }));
        QVERIFY(until([this] { return tab().output(3)->state() == IoChannel::State::On; }));
        QCOMPARE(cell().truth().runtimeState, RuntimeState::Playing);
        QCOMPARE(bench_->window.session().state().control, ControlState::InControl);
    }

    void settingAnOutputDoesNotStopAForeignProgram() {
        bench_->window.session().releaseControl();
        QVERIFY(
            until([this] { return bench_->window.session().state().control != ControlState::InControl; }));
        QTcpSocket client;
        client.connectToHost(cell().robot.listenAddress(), cell().robot.ports().secondary);
        QVERIFY(client.waitForConnected(60'000));
        client.write("def theirs():\n  while True:\n    sync()\n  end\nend\n");
        client.flush();
        QVERIFY(until([this] { return bench_->window.session().state().foreignProgramRuns(); }));
        bench_->window.session().confirmChanges();
        tab().output(9)->click();
        QVERIFY(until([this] { return output(9); }));
        cell().advanceMs(200);
        QCOMPARE(cell().truth().runtimeState, RuntimeState::Playing);
    }

    void aPulseSwitchesOnAndOffAgain() {
        IoChannel* channel = tab().output(4);
        channel->setFocus();
        QTest::keyClick(channel, Qt::Key_P);
        QVERIFY(until([this] { return output(4); }));
        QVERIFY(until([this] { return !output(4); }));
    }

    // The robot measures the duration, so that a window that hangs does not leave an output on.
    void aPulseEndsWhenTheWindowHangs() {
        IoChannel* channel = tab().output(4);
        channel->setFocus();
        QTest::keyClick(channel, Qt::Key_P);
        QVERIFY(until([this] { return output(4); }));
        const double on = cell().truth().timestamp;
        int hung = 0;
        for (; output(4) && hung < 3'000; hung += 20) {
            cell().advanceWithFrozenInterface(20);
        }
        QVERIFY2(!output(4), "the output stayed on");
        const double seconds = cell().truth().timestamp - on;
        QVERIFY2(std::abs(seconds - 0.5) < 0.05, qPrintable(QString::number(seconds)));
    }

    // A click switches the output, and then P pulses it, as described in the tooltip.
    void theClickedRowIsPulsedByItsKey() {
        IoChannel* channel = tab().output(4);
        QTest::mouseClick(channel, Qt::LeftButton);
        QVERIFY(until([this] { return output(4); }));
        QVERIFY(channel->hasFocus());
        QTest::mouseClick(channel, Qt::LeftButton);
        QVERIFY(until([this] { return !output(4); }));
        QTest::keyClick(bench_->window.focusWidget(), Qt::Key_P);
        QVERIFY(until([this] { return output(4); }));
        QVERIFY(until([this] { return !output(4); }));
    }
    // This window started the pulse, so monitor-only mode must not leave the output on.
    void monitorOnlyEndsARunningPulse() {
        QStringList warnings;
        const test::Listening listening =
            test::onMessage(bench_->window.session().journal(), &bench_->window,
                            [&warnings](Severity severity, const QString& text) {
                                if (severity != Severity::Info) {
                                    warnings << text;
                                }
                            });
        bench_->window.session().outputs().pulseDigitalOutput(4, 30);
        QVERIFY(until([this] { return output(4); }));
        QVERIFY(until([this] { return tab().output(4)->state() == IoChannel::State::On; }));
        bench_->window.session().setMonitorOnly(true);
        QVERIFY(until([this] { return !output(4); }));
        cell().advanceMs(3000);
        QVERIFY(!output(4));
        QVERIFY2(warnings.isEmpty(), qPrintable(warnings.join('\n')));
    }

    // The robot ends the pulse with the control program that times it, and nothing is reported as a fault.
    void releasingControlEndsARunningPulse() {
        QStringList warnings;
        RobotSession& session = bench_->window.session();
        const test::Listening listening = test::onMessage(
            session.journal(), &bench_->window, [&warnings](Severity severity, const QString& text) {
                if (severity != Severity::Info) {
                    warnings << text;
                }
            });
        session.outputs().pulseDigitalOutput(4, 30);
        QVERIFY(until([this] { return output(4); }));
        QVERIFY(until([this] { return tab().output(4)->state() == IoChannel::State::On; }));
        const double released = cell().truth().timestamp;
        session.releaseControl();
        QVERIFY(until([this] { return !output(4); }));
        QVERIFY2(cell().truth().timestamp - released < 25,
                 "the pulse ended after its duration, not with the release of control");
        QVERIFY(until([&session] { return session.state().control != ControlState::InControl; }));
        cell().advanceMs(3000);
        QVERIFY(!output(4));
        QVERIFY2(warnings.isEmpty(), qPrintable(warnings.join('\n')));
    }

    // Without control, no program on the robot can time the pulse.
    void aPulseIsRefusedWithoutControl() {
        bench_->window.session().releaseControl();
        QVERIFY(
            until([this] { return bench_->window.session().state().control != ControlState::InControl; }));
        IoChannel* channel = tab().output(4);
        channel->setFocus();
        QTest::keyClick(channel, Qt::Key_P);
        cell().advanceMs(200);
        QVERIFY(!output(4));
        auto& notice = find<NoticeBar>("io.notice");
        QVERIFY(notice.isVisible());
        QVERIFY2(notice.text().contains("Take control"), qPrintable(notice.text()));
    }

    // A program that was stopped externally cannot end its pulse, so the window ends the pulse.
    void aPulseOfAStoppedProgramIsEnded() {
        tab().output(4)->setFocus();
        QTest::keyClick(tab().output(4), Qt::Key_P);
        QVERIFY(until([this] { return output(4); }));
        QTcpSocket client;
        client.connectToHost(cell().robot.listenAddress(), cell().robot.ports().secondary);
        QVERIFY(client.waitForConnected(60'000));
        client.write("stop program\n");
        client.flush();
        QVERIFY(until([this] { return cell().truth().runtimeState == RuntimeState::Stopped; }));
        QVERIFY2(output(4), "the output was switched off by the robot");
        QVERIFY(until([this] { return !output(4); }));
    }

    void analogValuesAreShownWithDomainAndRange() {
        cell().robot.setAnalogInput(0, 5.0);
        AnalogRow* row = tab().analogInput(0);
        QVERIFY(until([row] { return row->valueText().startsWith("5.00 V"); }));
        row->setScale({0, 10, "bar"});
        QVERIFY(until([row] { return row->valueText() == "5.00 V · 5.00 bar"; }));
        QVERIFY(AnalogScale::fromText(row->scale().toText()).at(0.25) == 2.5);
        QVERIFY(!AnalogScale::fromText("nonsense|1|bar").isSet());
        QVERIFY2(tab().names().value("AI 0 scale").contains("bar"), "the scale is not stored with the names");
    }

    void anAnalogOutputIsSetWithItsDomain() {
        find<QComboBox>("io.AO1.domain").setCurrentIndex(1);
        find<QDoubleSpinBox>("io.AO1.wanted").setValue(7.5);
        find<QPushButton>("io.AO1.set").click();
        AnalogRow* row = tab().analogOutput(1);
        QVERIFY(until([row] { return row->valueText() == "7.50 V"; }));
        find<QComboBox>("io.AO1.domain").setCurrentIndex(0);
        find<QDoubleSpinBox>("io.AO1.wanted").setValue(12);
        find<QPushButton>("io.AO1.set").click();
        QVERIFY(until([row] { return row->valueText() == "12.00 mA"; }));
    }

    void registerReachesAProgramAndIsReadBack() {
        bench_->window.session().releaseControl();
        QVERIFY(
            until([this] { return bench_->window.session().state().control != ControlState::InControl; }));
        QTcpSocket client;
        client.connectToHost(cell().robot.listenAddress(), cell().robot.ports().secondary);
        QVERIFY(client.waitForConnected(60'000));
        client.write(
            "def mirror():\n  while True:\n    write_output_integer_register(40, "
            "read_input_integer_register(36))\n    sync()\n  end\nend\n");
        client.flush();
        QVERIFY(until([this] { return bench_->window.session().state().foreignProgramRuns(); }));
        bench_->window.session().confirmChanges();
        find<QComboBox>("io.register.kind").setCurrentIndex(0);
        find<QDoubleSpinBox>("io.register.number").setValue(36);
        find<QDoubleSpinBox>("io.register.value").setValue(4711);
        find<QPushButton>("io.register.write").click();
        QVERIFY(until([this] { return tab().registers()->valueText("Int 40") == "4711"; }));
    }

    void nothingIsCutOffAtTheSmallestSize_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x720") << QSize(1280, 720);
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }
    void nothingIsCutOffAtTheSmallestSize() {
        QFETCH(QSize, size);
        tab().setNames(
            {{"DO 0", "Gripper"}, {"DI 3", "Part there"}, {"AI 0", "Pressure"}, {"AI 0 scale", "0|10|bar"}});
        bench_->window.resize(size);
        cell().advanceMs(100);
        auto* scroll = tab().findChild<QScrollArea*>("io.scroll");
        QVERIFY2(scroll->widget()->width() <= scroll->viewport()->width(),
                 qPrintable(QString::number(scroll->widget()->width() - scroll->viewport()->width())));
        for (const char* name : {"io.AO0.set", "io.register.write", "io.AO1.wanted"}) {
            auto& control = find<QWidget>(name);
            const QRect at(control.mapTo(scroll->widget(), QPoint(0, 0)), control.size());
            QVERIFY2(scroll->widget()->rect().contains(at), name);
            QVERIFY2(control.width() >= control.minimumSizeHint().width(), name);
        }
        const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (!folder.isEmpty()) {
            for (const int part : {0, 1}) {
                scroll->verticalScrollBar()->setValue(part * 10'000);
                QCoreApplication::processEvents();
                bench_->window.grab().save(
                    QStringLiteral("%1/io-%2-%3.png").arg(folder).arg(size.width()).arg(part));
            }
        }
    }

    void searchShowsOnlyMatches() {
        tab().setNames({{"DO 1", "Gripper open"}, {"DI 7", "Part there"}});
        tab().search("gripper");
        QVERIFY(tab().output(1)->isVisible());
        QVERIFY(!tab().output(0)->isVisible() && !tab().input(7)->isVisible());
        QVERIFY(!tab().registers()->isVisible());
        tab().search("DI 7");
        QVERIFY(tab().input(7)->isVisible() && !tab().output(1)->isVisible());
        tab().search({});
        QVERIFY(tab().output(0)->isVisible() && tab().analogInput(0)->isVisible());
    }

    void anOutputInUseByAnotherClientIsLabelled() {
        bench_.reset();
        bench_ = std::make_unique<WindowBench>();
        bench_->window.show();
        io::OutputsOptions options;
        QVERIFY(cell().robot.start().ok());
        options.host = cell().robot.listenAddress();
        io::Outputs other(options, io::OutputFeedback{[] { return io::Report(); }});
        std::thread connecting([&] { (void)other.connect(Deadline::after(std::chrono::minutes(1))); });
        const bool connected =
            QTest::qWaitFor([&] { return cell().robot.step(), other.isConnected(); }, 60'000);
        connecting.join();
        QVERIFY(connected);
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        bench_->window.showTab("io");
        QVERIFY(until([this] { return !tab().output(0)->obstacle().isEmpty(); }));
        QVERIFY2(tab().output(0)->obstacle().contains("another RTDE client"),
                 qPrintable(tab().output(0)->obstacle()));
        QTest::mouseClick(tab().output(0), Qt::LeftButton);
        cell().advanceMs(100);
        QVERIFY(!output(0));
    }
};

QTEST_MAIN(TestIo)
#include "tst_io.moc"
