// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMetaEnum>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "widgets/common/elided_label.h"
#include "widgets/common/notice_bar.h"
#include "widgets/common/panel.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/state_chip.h"
#include "widgets/common/theme.h"
#include "widgets/hold/hold_to_run_button.h"

using namespace tiller;

class TestSharedWidgets : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void segmentIsChosenByClick() {
        SegmentedControl control({QStringLiteral("Base"), QStringLiteral("Tool"), QStringLiteral("View")});
        QSignalSpy changed(&control, &SegmentedControl::currentChanged);
        QCOMPARE(control.currentIndex(), 0);
        QTest::mouseClick(control.segment(1), Qt::LeftButton);
        QCOMPARE(control.currentIndex(), 1);
        QTest::mouseClick(control.segment(1), Qt::LeftButton);
        QCOMPARE(changed.count(), 1);
        QVERIFY(control.segment(1)->isChecked());
        QVERIFY(!control.segment(0)->isChecked());
    }
    void disabledSegmentShowsTheReason() {
        SegmentedControl control({QStringLiteral("Base"), QStringLiteral("Frame")});
        control.setSegmentEnabled(1, false, QStringLiteral("No frame taught yet"));
        QTest::mouseClick(control.segment(1), Qt::LeftButton);
        QCOMPARE(control.currentIndex(), 0);
        QCOMPARE(control.segment(1)->toolTip(), QStringLiteral("No frame taught yet"));
    }
    void wheelDoesNotChangeTheChoice() {
        SegmentedControl control({QStringLiteral("5"), QStringLiteral("20"), QStringLiteral("50")});
        control.resize(300, 38);
        control.show();
        QWheelEvent wheel(QPointF(5, 5), QPointF(5, 5), QPoint(), QPoint(0, -120), Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(control.segment(0), &wheel);
        QCOMPARE(control.currentIndex(), 0);
    }
    void everySegmentHasAName() {
        SegmentedControl control({QStringLiteral("Base"), QStringLiteral("Tool")});
        control.setNames(QStringLiteral("frame"), QStringLiteral("Frame"));
        auto* tool = control.findChild<QAbstractButton*>(QStringLiteral("frame.1"));
        QVERIFY(tool != nullptr);
        QCOMPARE(tool->accessibleName(), QStringLiteral("Frame: Tool"));
    }
    void longLabelIsElidedAndKeepsItsText() {
        const QString text = QStringLiteral("largest turn Wrist 2 41°, 2.4 s at 35 %");
        ElidedLabel label(text);
        label.resize(60, 20);
        label.show();
        QVERIFY(label.text().size() < text.size());
        QCOMPARE(label.fullText(), text);
        QCOMPARE(label.toolTip(), text);
        label.resize(label.sizeHint());
        QCOMPARE(label.text(), text);
        QVERIFY(label.toolTip().isEmpty());
    }
    void panelReplacesItsContent() {
        Panel panel(QStringLiteral("Jog"));
        auto* content = new QLabel(QStringLiteral("inside"));
        panel.setContent(content);
        QCOMPARE(panel.content(), content);
        panel.setHint(QStringLiteral("hold to move"));
        QCOMPARE(panel.title(), QStringLiteral("Jog"));
        QVERIFY(panel.isAncestorOf(content));
    }
    void chipShrinksToItsMinimum() {
        StateChip chip(QStringLiteral("LINK"));
        chip.setState(QStringLiteral("500 Hz · 0 late · 4.0 ms"), StateChip::Shape::None,
                      StateChip::Emphasis::Normal);
        QVERIFY(chip.minimumSizeHint().width() < chip.sizeHint().width());
        const int before = chip.sizeHint().width();
        chip.setState(QStringLiteral("NO DATA"), StateChip::Shape::Cross, StateChip::Emphasis::Alarm);
        QVERIFY(chip.sizeHint().width() < before);
        QCOMPARE(chip.accessibleDescription(), QStringLiteral("NO DATA"));
    }
    void everyShapeOfAChipLooksDifferent() {
        applyTheme(*qApp, Theme::light());
        QList<QImage> seen;
        const QMetaEnum shapes = QMetaEnum::fromType<StateChip::Shape>();
        for (int i = 0; i < shapes.keyCount(); ++i) {
            StateChip chip(QStringLiteral("SAFETY"));
            chip.setState(QString(), static_cast<StateChip::Shape>(shapes.value(i)),
                          StateChip::Emphasis::Normal);
            chip.resize(120, StateChip::kHeight);
            const QImage image = chip.grab().toImage();
            QVERIFY2(!seen.contains(image), shapes.key(i));
            seen.append(image);
        }
    }

    void standardWidgetsFollowTheTheme() {
        for (const Theme* theme : {&Theme::light(), &Theme::dark()}) {
            applyTheme(*qApp, *theme);
            HoldPolicy policy;
            QWidget window;
            auto* outer = new QVBoxLayout(&window);
            outer->setContentsMargins(11, 11, 11, 11);
            auto* panel = new Panel(QString());
            auto* tabs = new QTabBar;
            for (const char* name : {"Waypoints", "Program", "Frames", "I/O", "Log"}) {
                tabs->addTab(QLatin1String(name));
            }
            panel->setHeaderWidget(tabs);
            auto* body = new QWidget;
            auto* layout = new QVBoxLayout(body);
            auto* row = new QHBoxLayout;
            auto* teach = new QPushButton(QStringLiteral("Teach here  T"));
            teach->setProperty("primary", true);
            row->addWidget(teach);
            row->addWidget(new QPushButton(QStringLiteral("Touch up  U")));
            row->addWidget(new HoldToRunButton(QStringLiteral("Go to (hold)  G"), policy));
            auto* off = new QPushButton(QStringLiteral("Off"));
            off->setEnabled(false);
            row->addWidget(off);
            layout->addLayout(row);
            auto* table = new QTableWidget(3, 4);
            table->setHorizontalHeaderLabels({QStringLiteral("#"), QStringLiteral("Name"),
                                              QStringLiteral("Move"), QStringLiteral("Frame")});
            table->verticalHeader()->hide();
            table->setShowGrid(false);
            table->setSelectionBehavior(QAbstractItemView::SelectRows);
            for (int i = 0; i < 12; ++i) {
                table->setItem(i / 4, i % 4, new QTableWidgetItem(QStringLiteral("cell %1").arg(i)));
            }
            table->selectRow(1);
            layout->addWidget(table);
            auto* fields = new QHBoxLayout;
            fields->addWidget(new QLineEdit(QStringLiteral("192.168.0.10")));
            auto* combo = new QComboBox;
            combo->addItem(QStringLiteral("30 s"));
            fields->addWidget(combo);
            auto* box = new QCheckBox(QStringLiteral("Output 0"));
            box->setChecked(true);
            fields->addWidget(box);
            fields->addWidget(new QSpinBox);
            layout->addLayout(fields);
            panel->setContent(body);
            outer->addWidget(panel);
            window.resize(560, 360);
            window.show();
            const QImage picture = window.grab().toImage();
            QCOMPARE(picture.pixelColor(4, 4), theme->background);
            QCOMPARE(picture.pixelColor(20, picture.height() - 16), theme->panel);
            const QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
            if (!folder.isEmpty()) {
                picture.save(folder + (theme->isDark() ? QStringLiteral("/standard-dark.png")
                                                       : QStringLiteral("/standard-light.png")));
            }
        }
        applyTheme(*qApp, Theme::light());
    }

    void aNoticeEndsWithItsCause() {
        NoticeBar notice;
        notice.show(NoticeBar::Kind::Warning, {.title = "damaged", .text = {}, .cause = "file"});
        notice.resolve("other");
        QVERIFY(notice.isVisible());
        notice.dismissWithoutCause();
        QVERIFY(notice.isVisible());
        notice.resolve("file");
        QVERIFY(!notice.isVisible());
    }

    void aNoticeReappearsAfterThoseAboveItEnd() {
        NoticeBar notice;
        notice.show(NoticeBar::Kind::Warning, {.title = "damaged", .text = {}, .cause = "file"});
        notice.show(NoticeBar::Kind::Warning, {.title = "taken", .text = {}, .cause = "lock"});
        notice.show(NoticeBar::Kind::Question, "Path recorded", {});
        QVERIFY(notice.title().contains("Path recorded"));
        notice.dismiss();
        QVERIFY(notice.title().contains("taken"));
        notice.resolve("file");
        QVERIFY(notice.isVisible());
        notice.dismiss();
        QVERIFY(!notice.isVisible());
    }

    void questionEndsWhenItsDataChange() {
        NoticeBar notice;
        notice.show(NoticeBar::Kind::Question, "Path recorded", {});
        notice.dismissQuestion();
        QVERIFY(notice.isVisible());
        notice.show(NoticeBar::Kind::Question, "Touch up?", {}, "Touch up", [] {});
        notice.dismissQuestion();
        QVERIFY(!notice.isVisible());
    }

    // Closing a notice may show the next notice. A second click at the same position must not close the next
    // notice unread.
    void aSecondClickDoesNotCloseTheNoticeOfTheFirst() {
        NoticeBar notice;
        notice.resize(400, 120);
        notice.show(NoticeBar::Kind::Warning, QStringLiteral("first"), QStringLiteral("text"),
                    QStringLiteral("Do it"), [&notice] {
                        notice.show(NoticeBar::Kind::Warning, QStringLiteral("second"),
                                    QStringLiteral("text"), {}, {});
                    });
        QVERIFY(QTest::qWaitForWindowExposed(&notice));
        const auto* accept = notice.findChild<QPushButton*>(QStringLiteral("notice.accept"));
        QVERIFY(accept != nullptr);
        const QPoint at = accept->geometry().center();
        QTest::mouseClick(notice.childAt(at), Qt::LeftButton);
        QVERIFY(notice.title().contains(QStringLiteral("second")));
        QWidget* there = notice.childAt(at);
        QTest::mouseClick(there != nullptr ? there : &notice, Qt::LeftButton, {},
                          there != nullptr ? QPoint() : at);
        QVERIFY2(notice.isVisible(), "the second click closed the notice");
    }
};

QTEST_MAIN(TestSharedWidgets)
#include "tst_shared_widgets.moc"
