// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gripper page in the real window, with real sockets and a simulated gripper. The gripper may also stop
// responding or disconnect.

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <atomic>
#include <thread>

#include "resources/resources.h"
#include "robot/io/outputs.h"
#include "robot/station/link/robotiq_link.h"
#include "tests/support/event_spy.h"
#include "tests/support/go_on_until.h"
#include "tests/support/raw_peer.h"
#include "tests/support/window_bench.h"
#include "tests/ui/clipping.h"
#include "tests/ui/jog_fixture.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/density.h"
#include "widgets/io/gripper_panel.h"
#include "widgets/io/io_channel.h"
#include "widgets/io/io_tab.h"

using namespace tiller;
using namespace tiller::test;

namespace {

/// Indices in the list of grippers, which starts with "None".
enum Choice { kTwoF85 = 1, kTwoF140, kHandE, kOneOutput, kTwoOutputs };

/// An active gripper that holds an object. It can be made to stop responding.
struct HoldingGripper {
    std::atomic<bool> mute{false};

    void serve(RawPeer::Link& link) {
        for (QByteArray line = link.readLine(); !line.isNull(); line = link.readLine()) {
            if (mute) {
                continue;
            }
            static const QMap<QByteArray, QByteArray> kValues = {
                {"STA", "3"}, {"FLT", "0"}, {"GTO", "1"}, {"OBJ", "2"}, {"PRE", "255"}, {"POS", "120"}};
            const QByteArray name = line.split(' ').value(1);
            link.send(line.startsWith("GET") ? name + ' ' + kValues.value(name) + '\n' : "ack");
        }
    }
};

}  // namespace

class TestGripper : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<WindowBench> bench_;
    QStringList said_;

    VirtualCell& cell() { return bench_->cell; }
    GripperPanel& panel() { return bench_->find<GripperPanel>("gripper"); }
    QPushButton& key(const char* name) { return bench_->find<QPushButton>(name); }
    QString text(const char* name) { return bench_->find<QLabel>(name).text(); }
    bool output(int number) { return (cell().truth().digitalOutputs >> number & 1) != 0; }
    bool wasSaid(const QString& words) {
        return std::any_of(said_.begin(), said_.end(), [&](const QString& s) { return s.contains(words); });
    }
    /// Also waits in real time, because a separate thread queries the gripper.
    bool until(const std::function<bool()>& condition) { return goOnUntil(cell(), condition); }
    /// Waits in real time. Robot time does not advance.
    bool untilReal(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 20'000); }
    void begin(const simulator::SimulatorOptions& robot = VirtualCell::options()) {
        bench_ = std::make_unique<WindowBench>(robot);
        said_.clear();
        test::onMessage(bench_->window.session().journal(), &bench_->window,
                        [this](Severity, const QString& words) { said_ << words; });
        bench_->window.setTheme("light");
        bench_->show(QSize(1280, 720));
        panel().setClock(bench_->clock);
        bench_->window.showTab("gripper");
    }
    /// Selects an entry by keyboard, starting with "None".
    void choose(Choice choice) {
        auto& list = bench_->find<QComboBox>("gripper.kind");
        QVERIFY(until([&list] { return list.isEnabled(); }));
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Home);
        for (int i = 0; i < choice; ++i) {
            QTest::keyClick(&list, Qt::Key_Down);
        }
        QCOMPARE(list.currentIndex(), int(choice));
    }
    void click(const char* name) {
        QVERIFY2(until([&] { return key(name).isEnabled(); }), qPrintable(key(name).toolTip()));
        QTest::mouseClick(&key(name), Qt::LeftButton);
    }
    void type(const char* box, const QString& figure) {
        auto& field = bench_->find<DecimalSpinBox>(box);
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, figure);
    }
    void activate() {
        click("gripper.activate");
        QVERIFY(until([this] { return text("gripper.state") == "active"; }));
    }

private Q_SLOTS:
    void initTestCase() { initResources(); }
    void init() {
        begin();
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        driveKeys(cell(), bench_->window.jogColumn().holdKeys());
    }
    void cleanup() {
        bench_.reset();
        applyDensity(*qApp, Density::Mouse);
    }

    void buttonsAreDisabledWithoutAGripper() {
        QVERIFY(!key("gripper.close").isVisible());
        QVERIFY(!key("gripper.activate").isVisible());
        QVERIFY2(text("gripper.remedy").contains("stored"), qPrintable(text("gripper.remedy")));
    }

    void gripperMustBeActivatedBeforeItOpensOrCloses() {
        choose(kTwoF85);
        QVERIFY(until([this] { return text("gripper.state") == "not active"; }));
        QVERIFY(until([this] { return key("gripper.activate").isEnabled(); }));
        for (const char* name : {"gripper.open", "gripper.close", "gripper.move"}) {
            QVERIFY2(!key(name).isEnabled(), name);
            QVERIFY2(key(name).toolTip().contains("Activate"), qPrintable(key(name).toolTip()));
        }
        activate();
        QVERIFY(until([this] { return key("gripper.close").isEnabled(); }));
        QVERIFY(!key("gripper.activate").isEnabled());
        QVERIFY(wasSaid("Gripper: activate"));
        QVERIFY(wasSaid("The gripper is active"));
        QVERIFY(key("gripper.close").toolTip().contains("does not open the gripper"));
    }

    void gripperOpensClosesAndReportsHeldObjects() {
        choose(kTwoF85);
        activate();
        click("gripper.close");
        QVERIFY(until([this] { return text("gripper.opening") == "0.0 mm"; }));
        QVERIFY(until([this] { return text("gripper.holds") == "none"; }));
        QVERIFY2(wasSaid("Gripper: close (speed 50 %, force 20 %)"), qPrintable(said_.join('\n')));
        click("gripper.open");
        QVERIFY(until([this] { return text("gripper.opening") == "85.0 mm"; }));
        QVERIFY(cell().robot.inject("gripper-object 120").ok());
        click("gripper.close");
        QVERIFY(until([this] { return text("gripper.holds") == "external grip"; }));
        QCOMPARE(text("gripper.opening"), QString("41.2 mm"));
        QVERIFY(until([this] { return wasSaid("The gripper holds an object (41.2 mm open)"); }));
        // A stop of the arm does not affect the gripper.
        QTest::keyClick(&bench_->window, Qt::Key_Escape);
        cell().robot.protectiveStop();
        cell().advanceMs(500);
        QTest::qWait(300);
        QVERIFY(text("gripper.holds") == "external grip");
        // The gripper can still be opened, just as an output can still be switched.
        click("gripper.open");
        QVERIFY(until([this] { return text("gripper.opening") == "85.0 mm"; }));
        QVERIFY(until([this] { return text("gripper.holds") == "none"; }));
    }

    void anEnteredOpeningIsAppliedOnClick() {
        choose(kTwoF85);
        activate();
        click("gripper.close");
        QVERIFY(until([this] { return text("gripper.opening") == "0.0 mm"; }));
        type("gripper.speed", "100");
        type("gripper.position", "40");
        QTest::keyClick(&bench_->find<DecimalSpinBox>("gripper.position"), Qt::Key_Return);
        cell().advanceMs(400);
        QTest::qWait(300);
        QCOMPARE(text("gripper.opening"), QString("0.0 mm"));  // Return does not move the fingers
        click("gripper.move");
        QVERIFY(until([this] { return text("gripper.opening").startsWith("40."); }));
        QVERIFY(until([this] { return wasSaid("Gripper: move to 40.0 mm (speed 100 %"); }));
    }

    void valueOutOfRangeIsRefusedWithoutMotion() {
        choose(kTwoF85);
        activate();
        click("gripper.open");
        QVERIFY(until([this] { return text("gripper.opening") == "85.0 mm" && wasSaid("Gripper: open"); }));
        said_.clear();
        type("gripper.position", "86");
        click("gripper.move");
        QVERIFY(bench_->find<DecimalSpinBox>("gripper.position").isRefused());
        QVERIFY(bench_->find<DecimalSpinBox>("gripper.position").accessibleDescription().contains("85"));
        type("gripper.force", "101");
        click("gripper.close");
        cell().advanceMs(400);
        QTest::qWait(300);
        QVERIFY2(!wasSaid("Gripper:"), qPrintable(said_.join('\n')));
        QCOMPARE(text("gripper.opening"), QString("85.0 mm"));
    }

    void spacePressesNoButtonAndEnterPressesOnce() {
        choose(kTwoF85);
        activate();
        QVERIFY(until([this] { return key("gripper.close").isEnabled(); }));
        key("gripper.close").setFocus();
        QTest::keyClick(&key("gripper.close"), Qt::Key_Space);
        cell().advanceMs(400);
        QTest::qWait(300);
        QVERIFY(!wasSaid("Gripper: close"));
        QTest::keyClick(&key("gripper.close"), Qt::Key_Return);
        QVERIFY(until([this] { return text("gripper.opening") == "0.0 mm"; }));
    }

    void aDisconnectedGripperIsUnknownWithASolution() {
        HoldingGripper gripper;
        auto peer = std::make_unique<RawPeer>([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        panel().setAddress("127.0.0.1", peer->port());
        choose(kTwoF85);
        QVERIFY(until([this] { return text("gripper.holds") == "external grip"; }));
        QVERIFY(until([this] { return key("gripper.open").isEnabled(); }));
        peer.reset();
        QVERIFY(until([this] { return text("gripper.state") == "unknown"; }));
        QCOMPARE(text("gripper.holds"), QString("unknown"));
        QCOMPARE(text("gripper.opening"), QString("unknown"));
        QVERIFY(until([this] { return text("gripper.remedy").contains("URCap"); }));
        QVERIFY(!key("gripper.open").isEnabled());
        QCOMPARE(key("gripper.open").toolTip(), text("gripper.remedy"));
        QVERIFY(wasSaid("No gripper service responds"));
    }

    void anUnresponsiveGripperIsShownAsUnknownImmediately() {
        HoldingGripper gripper;
        RawPeer peer([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        panel().setAddress("127.0.0.1", peer.port());
        choose(kTwoF85);
        QVERIFY(until([this] { return key("gripper.open").isEnabled(); }));
        gripper.mute = true;
        QVERIFY(until([this] { return text("gripper.state") == "unknown"; }));
        QVERIFY2(text("gripper.remedy").contains("is not responding"), qPrintable(text("gripper.remedy")));
        QVERIFY(!key("gripper.close").isEnabled());
        // Outputs are independent of the gripper.
        auto* tab = bench_->window.findChild<IoTab*>();
        tab->output(3)->click();
        QVERIFY(until([this] { return output(3); }));
        gripper.mute = false;
        QVERIFY(until([this] { return text("gripper.holds") == "external grip"; }));
        QVERIFY(until([this] { return wasSaid("The gripper responds again"); }));
    }

    void aReplacedActivationIsNotReported() {
        HoldingGripper gripper;
        RawPeer peer([&gripper](RawPeer::Link& link) { gripper.serve(link); });
        RobotiqLink link(bench_->window.session());
        link.follow("127.0.0.1", peer.port(), GripperChoice::Model::TwoF85);
        QVERIFY(untilReal([&link] { return link.state().has_value(); }));
        said_.clear();
        link.move(io::kRobotiqMost, 255, 0, "first");
        link.activate();
        link.move(io::kRobotiqMost, 255, 0, "second");
        QVERIFY(untilReal([this] { return wasSaid("second"); }));
        QVERIFY(untilReal([&link] { return !link.isBusy(); }));
        QVERIFY(wasSaid("first"));
        QVERIFY2(!wasSaid("activate") && !wasSaid("is active"), qPrintable(said_.join('\n')));
    }

    void stateIsUnknownWithoutArmPower() {
        bench_.reset();
        auto options = VirtualCell::options();
        options.poweredOn = false;
        begin(options);
        QVERIFY2(cell().connect(), qPrintable(cell().what()));
        choose(kHandE);
        QVERIFY(until([this] { return text("gripper.remedy").contains("Power on the arm"); }));
        QCOMPARE(text("gripper.state"), QString("unknown"));
        QVERIFY(!key("gripper.activate").isEnabled());
    }

    void twoOutputsOpenAndClose() {
        panel().setNames({{"TO 0", "Jaw"}});
        choose(kTwoOutputs);
        QCOMPARE(bench_->find<QComboBox>("gripper.closeOutput").currentText(), QString("TO 0 · Jaw"));
        QVERIFY2(!key("gripper.close").isEnabled(), "a second click after the selection could press Close");
        QVERIFY(!key("gripper.activate").isVisible());
        QVERIFY(until([this] { return text("gripper.state") == "both outputs off"; }));
        click("gripper.close");
        QVERIFY(until([this] { return output(16) && !output(17); }));
        QVERIFY(until([this] { return text("gripper.state") == "close requested"; }));
        click("gripper.open");
        QVERIFY(until([this] { return !output(16) && output(17); }));
        QVERIFY(until([this] { return text("gripper.state") == "open requested"; }));
        QVERIFY(until([this] { return wasSaid("Gripper: open (TO 0: off, TO 1: on)"); }));
        // The display shows the state reported by the robot, regardless of its cause.
        bench_->window.session().outputs().setDigitalOutput(16, true);
        QVERIFY(until([this] { return text("gripper.state") == "both outputs on"; }));
    }

    void oneOutputCloses() {
        choose(kOneOutput);
        auto& list = bench_->find<QComboBox>("gripper.closeOutput");
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Home);
        QVERIFY(until([this] { return text("gripper.state") == "open requested"; }));
        click("gripper.close");
        QVERIFY(until([this] { return output(0) && text("gripper.state") == "close requested"; }));
        click("gripper.open");
        QVERIFY(until([this] { return !output(0) && text("gripper.state") == "open requested"; }));
        QCOMPARE(app::Settings(bench_->file).gripper("simulator"), QString("output|0"));
    }

    void unconfirmedOutputIsReported() {
        panel().setOutputSetter([](std::uint32_t, std::uint32_t, const QString&) {});
        choose(kTwoOutputs);
        click("gripper.close");
        QCOMPARE(text("gripper.state"), QString("pending…"));
        cell().advanceMs(2200);
        QVERIFY(until([this] { return text("gripper.remedy").contains("did not confirm"); }));
        QCOMPARE(text("gripper.state"), QString("both outputs off"));
    }

    void theSameOutputIsRefusedForBothDirections() {
        choose(kTwoOutputs);
        auto& list = bench_->find<QComboBox>("gripper.openOutput");
        list.setFocus();
        QTest::keyClick(&list, Qt::Key_Up);
        QVERIFY(until([this] { return text("gripper.remedy").contains("different outputs"); }));
        QVERIFY(!key("gripper.close").isEnabled());
        QCOMPARE(app::Settings(bench_->file).gripper("simulator"), QString("outputs|16|17"));
    }

    void anOutputInUseByAnotherClientDisablesTheButtons() {
        bench_.reset();
        begin();
        QVERIFY(cell().robot.start().ok());
        io::OutputsOptions options;
        options.host = cell().robot.listenAddress();
        io::Outputs other(options, io::OutputFeedback{[] { return io::Report(); }});
        std::thread connecting([&] { (void)other.connect(Deadline::after(std::chrono::minutes(1))); });
        const bool connected =
            QTest::qWaitFor([&] { return cell().robot.step(), other.isConnected(); }, 60'000);
        connecting.join();
        QVERIFY(connected);
        QVERIFY2(cell().bringUp(), qPrintable(cell().what()));
        choose(kTwoOutputs);
        QVERIFY(until([this] { return key("gripper.close").toolTip().contains("another RTDE client"); }));
        QVERIFY(!key("gripper.close").isEnabled());
        QTest::mouseClick(&key("gripper.close"), Qt::LeftButton);
        cell().advanceMs(100);
        QVERIFY(!output(16));
    }

    void oldDataDisableTheButtons() {
        choose(kTwoOutputs);
        QVERIFY(until([this] { return key("gripper.close").isEnabled(); }));
        // Time advances without data.
        bench_->clock.advanceNs(400 * kNsPerMs);
        QVERIFY(untilReal([this] { return !key("gripper.close").isEnabled(); }));
        QCOMPARE(key("gripper.close").toolTip(),
                 QString("The robot is not sending data. Wait for data, or reconnect."));
        QTest::mouseClick(&key("gripper.close"), Qt::LeftButton);
        bench_->clock.advanceNs(1500 * kNsPerMs);
        QVERIFY(untilReal([this] { return text("gripper.state") == "unknown"; }));
        QVERIFY(!wasSaid("Gripper: close"));
    }

    void theGripperIsSavedForEachRobot() {
        choose(kTwoF140);
        QCOMPARE(app::Settings(bench_->file).gripper("simulator"), QString("robotiq|2F-140"));
        QVERIFY(app::Settings(bench_->file).gripper("192.168.0.10").isEmpty());
        RobotSession& session = bench_->window.session();
        session.disconnectFromRobot();
        auto& list = bench_->find<QComboBox>("gripper.kind");
        QVERIFY(untilReal([&list] { return list.currentIndex() == 0 && !list.isEnabled(); }));
        QVERIFY2(text("gripper.remedy").contains("Connect to a robot"), qPrintable(text("gripper.remedy")));
        session.connectTo({"Virtual UR5e", cell().robot.listenAddress(), 0, true});
        QVERIFY(until([&list] { return list.currentIndex() == kTwoF140; }));
        QVERIFY(until([this] { return text("gripper.state") == "not active"; }));
    }

    void nothingIsCutOff_data() {
        QTest::addColumn<int>("choice");
        QTest::addColumn<bool>("touch");
        for (const bool touch : {false, true}) {
            for (const auto& [name, choice] :
                 {std::pair("none", 0), std::pair("robotiq", int(kTwoF140)),
                  std::pair("one", int(kOneOutput)), std::pair("two", int(kTwoOutputs))}) {
                QTest::newRow(qPrintable(QStringLiteral("%1, %2").arg(name, touch ? "touch" : "mouse")))
                    << choice << touch;
            }
        }
    }
    void nothingIsCutOff() {
        QFETCH(int, choice);
        QFETCH(bool, touch);
        app::Preferences preferences;
        preferences.density = touch ? Density::Touch : Density::Mouse;
        bench_->window.applyPreferences(preferences);
        panel().setNames({{"TO 0", "Jaw close"}, {"TO 1", "Jaw open"}});
        choose(static_cast<Choice>(choice));
        cell().advanceMs(200);
        QTest::qWait(300);
        const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
        if (!folder.isEmpty()) {
            bench_->window.grab().save(QStringLiteral("%1/gripper-%2-%3.png")
                                           .arg(folder)
                                           .arg(choice)
                                           .arg(touch ? "touch" : "mouse"));
        }
        const QStringList cut = clipped(bench_->window);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join('\n')));
    }
};

QTEST_MAIN(TestGripper)
#include "tst_gripper.moc"
