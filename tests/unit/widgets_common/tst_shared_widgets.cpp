// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QMetaEnum>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "widgets/common/elided_label.h"
#include "widgets/common/panel.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/state_chip.h"
#include "widgets/common/theme.h"

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
    void disabledSegmentCannotBeChosenAndSaysWhy() {
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
    void longLabelGivesWayAndKeepsItsText() {
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
    void chipGivesWayButNotBelowItsLeast() {
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
};

QTEST_MAIN(TestSharedWidgets)
#include "tst_shared_widgets.moc"
