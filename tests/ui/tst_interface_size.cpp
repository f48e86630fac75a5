// SPDX-License-Identifier: GPL-3.0-or-later
//
// The scale of the user interface takes effect at the next start, is limited by the screen size, and applies
// to buttons and plots. Every test starts a separate application.

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>

#include "app/application.h"
#include "app/interface_size.h"
#include "app/main_window.h"
#include "app/settings_page.h"
#include "resources/resources.h"
#include "robot/core/clock.h"
#include "widgets/common/theme.h"
#include "widgets/jog/jog_pad.h"

using namespace tiller;
using namespace tiller::app;

namespace {

/// An application on a screen with this size [px].
class Start {
public:
    Start(QSize screen, int percent) {
        QFile file(folder_.filePath("screens.json"));
        if (!file.open(QIODevice::WriteOnly)) {
            qFatal("cannot write %s", qPrintable(file.fileName()));
        }
        file.write(QStringLiteral(R"({"screens": [{"name": "one", "x": 0, "y": 0, "width": %1, "height": %2,
            "logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1.0}]})")
                       .arg(screen.width())
                       .arg(screen.height())
                       .toUtf8());
        file.close();
        qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + file.fileName().toUtf8());
        sized_ = std::make_unique<SizedApplication>(1, argv_, percent);
        initResources();
        applyTheme(sized_->application(), Theme::light());
    }
    double ratio() const { return QGuiApplication::primaryScreen()->devicePixelRatio(); }
    QString setting() const { return folder_.filePath("settings.ini"); }

private:
    QTemporaryDir folder_;
    char name_[7] = "tiller";
    char* argv_[2] = {name_, nullptr};
    std::unique_ptr<SizedApplication> sized_;
};

}  // namespace

class TestInterfaceSize : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { qunsetenv("QT_SCALE_FACTOR"); }

    void invalidSizesInTheSettingsAreCorrected() {
        QCOMPARE(saneInterfaceSize(150), 150);
        QCOMPARE(saneInterfaceSize(160), 150);
        QCOMPARE(saneInterfaceSize(0), 100);
        QCOMPARE(saneInterfaceSize(-5), 100);
        QCOMPARE(saneInterfaceSize(100000), 200);
    }

    void noSizeIsLargerThanTheScreenAllows() {
        QCOMPARE(fittingInterfaceSize(200, {3840, 2160}), 200);
        QCOMPARE(fittingInterfaceSize(150, {3840, 2160}), 150);
        QCOMPARE(fittingInterfaceSize(200, {1920, 1053}), 150);
        QCOMPARE(fittingInterfaceSize(200, {1600, 900}), 125);
        QCOMPARE(fittingInterfaceSize(200, {1280, 720}), 100);
        QCOMPARE(fittingInterfaceSize(200, {800, 600}), 100);
    }

    void theApplicationStartsInASizeThatFits_data() {
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<int>("wanted");
        QTest::addColumn<int>("begun");
        QTest::newRow("4K at 100") << QSize(3840, 2160) << 100 << 100;
        QTest::newRow("4K at 150") << QSize(3840, 2160) << 150 << 150;
        QTest::newRow("4K at 200") << QSize(3840, 2160) << 200 << 200;
        QTest::newRow("Full HD at 125") << QSize(1920, 1080) << 125 << 125;
        QTest::newRow("another screen than yesterday") << QSize(1920, 1080) << 200 << 150;
        QTest::newRow("the smallest") << QSize(1280, 720) << 200 << 100;
    }
    void theApplicationStartsInASizeThatFits() {
        QFETCH(QSize, screen);
        QFETCH(int, wanted);
        QFETCH(int, begun);
        const Start start(screen, wanted);
        QCOMPARE(interfaceSize(), begun);
        QCOMPARE(start.ratio(), begun / 100.0);
        QCOMPARE(availableAtNormalSize(*QGuiApplication::primaryScreen()), screen);
        QPushButton key(QStringLiteral("Key"));
        key.show();
        QVERIFY(key.height() * start.ratio() >= 38 * begun / 100.0);
    }

    void desktopScalingIsMultiplied() {
        qputenv("QT_SCALE_FACTOR", "1.5");
        const Start start({3840, 2160}, 150);
        QCOMPARE(start.ratio(), 2.25);
        QCOMPARE(qgetenv("QT_SCALE_FACTOR"), QByteArray("1.5"));  // child processes must use their own scale
    }

    void keysAndPlotsGrowWithTheSize() {
        // Measures a button of the jog pad and a button of the plots, in pixels of the screen.
        const auto measure = [](int percent) {
            const Start start({3840, 2160}, percent);
            VirtualClock clock;
            MainWindow window(Settings(start.setting()), clock);
            window.resize(1920, 1080);
            window.show();
            QTest::qWait(50);
            const auto* key = window.findChild<JogKey*>(QStringLiteral("jog.Z+"));
            const auto* span = window.findChild<QWidget*>(QStringLiteral("plots.span"));
            return std::pair{key->height() * start.ratio(), span->height() * start.ratio()};
        };
        const auto [key, span] = measure(100);
        const auto [largeKey, largeSpan] = measure(200);
        QVERIFY2(largeKey >= 1.9 * key, qPrintable(QStringLiteral("%1 %2").arg(key).arg(largeKey)));
        QVERIFY2(largeSpan >= 1.9 * span, qPrintable(QStringLiteral("%1 %2").arg(span).arg(largeSpan)));
    }

    void theSizeSettingShowsWhenItApplies() {
        const Start start({1920, 1080}, 100);
        VirtualClock clock;
        MainWindow window(Settings(start.setting()), clock);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        QTest::keyClick(&window, Qt::Key_Comma, Qt::ControlModifier);
        auto* page = window.findChild<SettingsPage*>();
        QVERIFY(page != nullptr);
        auto* size = page->findChild<QComboBox*>("settings.size");
        const auto* note = page->findChild<QLabel*>("settings.sizeNote");
        QCOMPARE(size->count(), static_cast<int>(kInterfaceSizes.size()));
        size->setFocus(Qt::TabFocusReason);
        QTest::keyClick(size, Qt::Key_Down);
        QTest::keyClick(size, Qt::Key_Down);
        QVERIFY2(note->text().contains("restarted"), qPrintable(note->text()));
        QVERIFY2(!note->text().contains("room"), qPrintable(note->text()));
        QCOMPARE(readInterfaceSize(start.setting()), 150);
        QTest::keyClick(size, Qt::Key_Down);
        QVERIFY2(note->text().contains("150"), "the note does not name the largest size that fits");
        QCOMPARE(readInterfaceSize(start.setting()), 200);
        QCOMPARE(Settings(start.setting()).preferences().interfaceSize, 200);
        QTest::keyClick(size, Qt::Key_Home);
        QVERIFY2(!note->text().contains("restarted"), qPrintable(note->text()));
        QCOMPARE(readInterfaceSize(start.setting()), 100);
    }
};

QTEST_APPLESS_MAIN(TestInterfaceSize)
#include "tst_interface_size.moc"
