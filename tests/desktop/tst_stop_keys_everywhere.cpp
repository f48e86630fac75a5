// SPDX-License-Identifier: GPL-3.0-or-later
//
// In control, and for three seconds after control was lost, Space and Esc stop the arm from any window of the
// application that has the keyboard focus. This includes the main window behind a dialog, with each window
// manager. A program of another client that has just taken control moves the arm, because no other program
// can move it while a dialog is open.

#include <QTcpSocket>
#include <QTest>
#include <cstdio>
#include <memory>
#include <vector>

#include "tests/desktop/desktop_test.h"

namespace tiller::test {
namespace {

constexpr int kPrimaryPort = 30002;
constexpr const char* kWindowManagers[] = {"openbox", "xfwm4", "metacity"};

/// A window or menu, and the shortcut that opens it. A menu is opened by a click.
struct Opened {
    const char* name;
    const char* widget;
    int letter;  ///< letter pressed with Ctrl
    bool isMenu = false;
};
constexpr int kComma = 59;
constexpr int kLetterO = 32;
constexpr Opened kOpened[] = {
    {"settings", "settingsPage", kComma},
    {"palette", "commandPalette", kLetterK},
    {"file dialog", "QFileDialog", kLetterO},
    {"menu", "mainMenu", 0, true},
};

}  // namespace

class TestStopKeysEverywhere : public QObject {
    Q_OBJECT

    DesktopCell& cell() { return *cell_; }
    XHand& hand() { return cell_->hand(); }

    void bringUp(const QString& windowManager) {
        if (const QString obstacle = DesktopCell::obstacle(windowManager); !obstacle.isEmpty()) {
            QSKIP(qPrintable(obstacle));
        }
        if (cell_ && windowManager_ == windowManager) {
            return;
        }
        cell_.reset();
        auto made = std::make_unique<DesktopCell>(QSize(1280, 800), windowManager);
        QVERIFY2(made->bringUp(), qPrintable(made->what()));
        cell_ = std::move(made);
        windowManager_ = windowManager;
    }

    /// Closes everything that is open above the window with Esc, as a user would.
    bool closeAll() {
        return cell().until([&] {
            for (const Opened& each : kOpened) {
                const Place open = cell().place(each.widget);
                if (open.visible) {
                    if (!each.isMenu && !open.active) {
                        hand().activate(open.window);
                    }
                    hand().tap(kEscape);
                    (void)cell().until([&] { return !cell().place(each.widget).visible; }, 500);
                    return false;
                }
            }
            return true;
        });
    }

    void open(const Opened& what) {
        if (what.isMenu) {
            QVERIFY(cell().click("robotChip"));
        } else {
            hand().press(kControl);
            hand().tap(what.letter);
            hand().release(kControl);
        }
        QVERIFY(cell().untilShown(what.widget));
        QVERIFY(what.isMenu || cell().until([&] { return cell().place(what.widget).active; }));
    }

    /// Starts a program of another client, which takes control of the arm.
    void startForeignProgram() {
        pendant_ = std::make_unique<QTcpSocket>();
        pendant_->connectToHost(cell().host(), kPrimaryPort);
        QVERIFY(pendant_->waitForConnected(DesktopCell::kWaitTimeoutMs));
        pendant_->write(
            "def others():\n"
            "  while True:\n"
            "    movej([1.0, -1.7, -2.2, -0.8, 1.6, 0], a=1.2, v=0.25)\n"
            "    movej([-1.6, -1.7, -2.2, -0.8, 1.6, 0], a=1.2, v=0.25)\n"
            "  end\n"
            "end\n");
        QVERIFY(pendant_->waitForBytesWritten(DesktopCell::kWaitTimeoutMs));
        QVERIFY2(cell().arm().untilMoving(kGetsGoing),
                 "the program of the other client does not move the arm");
        // The window has detected the change at this point. Space and Esc still stop for three seconds.
        QVERIFY(cell().until([&] {
            return cell().place("nextStepButton").text == "Take control" &&
                   cell().place("nextStepButton").visible;
        }));
    }

    void verifyStands() {
        const Standstill stop = cell().standstill(kContract);
        qInfo("%s", words(stop).constData());
        QVERIFY2(stop.verdict == Standstill::Verdict::Stood, words(stop).constData());
        QVERIFY2(cell().arm().stays(0.5), "the arm stopped, but moved again by itself");
    }

private Q_SLOTS:
    void theKeyStops_data() {
        QTest::addColumn<QString>("windowManager");
        QTest::addColumn<int>("opened");
        QTest::addColumn<bool>("focusOnMainWindow");
        QTest::addColumn<int>("key");
        for (const char* windowManager : kWindowManagers) {
            for (int opened = 0; opened < int(std::size(kOpened)); ++opened) {
                for (const bool main : {true, false}) {
                    for (const int key : {int(kSpace), int(kEscape)}) {
                        if (!main || !kOpened[opened].isMenu) {
                            QTest::addRow("%s, %s, focus on %s, %s", windowManager, kOpened[opened].name,
                                          main ? "the main window" : "it", key == kSpace ? "Space" : "Esc")
                                << QString::fromLatin1(windowManager) << opened << main << key;
                        }
                    }
                }
            }
        }
    }
    void theKeyStops() {
        QFETCH(QString, windowManager);
        QFETCH(int, opened);
        QFETCH(bool, focusOnMainWindow);
        QFETCH(int, key);
        bringUp(windowManager);
        QVERIFY(cell_ != nullptr);
        QVERIFY(closeAll() && cell().toTheFront() && cell().takeControl());
        open(kOpened[opened]);
        if (focusOnMainWindow) {
            // A position in the main window that no dialog covers.
            const QRect window = cell().place("mainWindow").area;
            hand().moveTo({window.left() + 6, window.center().y()});
            hand().button(1, true);
            hand().button(1, false);
            // Some window managers, and Qt for some dialogs, pass the keyboard focus to the dialog
            // immediately.
            (void)cell().until([&] { return cell().place("mainWindow").active; }, 1000);
        }
        QVERIFY(cell().place(kOpened[opened].widget).visible);
        startForeignProgram();
        hand().tap(key);
        verifyStands();
        QVERIFY2(cell().place(kOpened[opened].widget).visible, "the key also closed the open window");
    }

    void stopIsClickedWhileADialogIsOpen_data() {
        QTest::addColumn<QString>("windowManager");
        for (const char* windowManager : kWindowManagers) {
            QTest::newRow(windowManager) << QString::fromLatin1(windowManager);
        }
    }
    void stopIsClickedWhileADialogIsOpen() {
        QFETCH(QString, windowManager);
        bringUp(windowManager);
        QVERIFY(cell_ != nullptr);
        QVERIFY(closeAll() && cell().toTheFront() && cell().takeControl());
        open(kOpened[0]);
        startForeignProgram();
        QVERIFY(cell().click("stopButton"));
        verifyStands();
    }

    void cleanup() {
        if (cell_) {
            hand().letGoOfAll();
        }
        pendant_.reset();
        if (QTest::currentTestFailed()) {
            cell_.reset();
        }
    }
    void cleanupTestCase() { cell_.reset(); }

private:
    QString windowManager_;
    std::unique_ptr<DesktopCell> cell_;
    std::unique_ptr<QTcpSocket> pendant_;
};

}  // namespace tiller::test

TILLER_DESKTOP_MAIN(tiller::test::TestStopKeysEverywhere)
#include "tst_stop_keys_everywhere.moc"
