// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths, speeds and orientations are displayed and typed in the units selected by the operator.

#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QTest>
#include <QWheelEvent>

#include "widgets/common/apply_notation.h"
#include "widgets/common/choice_box.h"
#include "widgets/common/decimal_spin_box.h"
#include "widgets/common/segmented_control.h"
#include "widgets/common/theme.h"

using namespace tiller;

namespace {

void turnWheel(QWidget& widget) {
    const QPointF at = QRectF(widget.rect()).center();
    QWheelEvent event(at, widget.mapToGlobal(at), QPoint(), QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

}  // namespace

class TestNotation : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { applyNotation(*qApp, {}); }
    void cleanupTestCase() { applyNotation(*qApp, {}); }

    // The typed text remains, so the box marks it as invalid.
    void aRefusedNumberIsMarkedUntilItIsCorrected() {
        applyTheme(*qApp, Theme::light());
        QWidget window;
        auto* box = new DecimalSpinBox(&window);
        auto* other = new QLineEdit(&window);
        other->move(0, 60);
        box->resize(120, 40);
        box->setRange(0, 100);
        box->setValue(20);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        other->setFocus();
        const auto type = [&](const char* text) {
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, text);
        };
        const auto isMarked = [&] {
            const QImage shown = box->grab().toImage();
            for (int x = 0; x < shown.width(); ++x) {
                if (shown.pixelColor(x, 0) == Theme::current().alarm) {
                    return true;
                }
            }
            return false;
        };
        QVERIFY(!isMarked());
        type("500");
        QVERIFY2(!isMarked(), "the box is marked while the user types");
        other->setFocus();
        QCOMPARE(box->text(), QString("500"));
        QCOMPARE(box->value(), 20.0);
        QVERIFY2(isMarked(), "the box is not marked although it shows 500 and the value is 20");
        QVERIFY2(box->toolTip().contains("20.00"), qPrintable(box->toolTip()));
        type("50");
        QVERIFY(!isMarked());
        other->setFocus();
        QCOMPARE(box->value(), 50.0);
        QVERIFY(box->toolTip().isEmpty());
        type("-3");
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(isMarked());
        QTest::keyClick(box, Qt::Key_Escape);
        QVERIFY2(!isMarked(), "the box is marked although it shows the value again");
        QCOMPARE(box->text(), QString("50.00"));
        // A value set by the program replaces the text, even if the value is unchanged.
        for (const double value : {30.0, 30.0}) {
            type("500");
            other->setFocus();
            QVERIFY(isMarked());
            box->setValue(value);
            QCOMPARE(box->text(), QString("30.00"));
            QTRY_VERIFY_WITH_TIMEOUT(!isMarked(), 60'000);
        }
    }

    void millimetresAreTheDefault() {
        QCOMPARE(format::length(0.2), QStringLiteral("200.00 mm"));
        QCOMPARE(format::lengthNumber(-0.0124, 1, true), QStringLiteral("−12.4"));
        QCOMPARE(format::shortLength(0.00005), QStringLiteral("0.05 mm"));
        QCOMPARE(format::shortLength(0.0001), QStringLiteral("0.1 mm"));
        QCOMPARE(format::shortLength(0.010), QStringLiteral("10 mm"));
        QCOMPARE(format::shortLength(0.0025), QStringLiteral("2.5 mm"));
        QCOMPARE(format::speed(0.25), QStringLiteral("250 mm/s"));
        QCOMPARE(format::speed(0.0005), QStringLiteral("0.5 mm/s"));
        QCOMPARE(format::speed(0.001), QStringLiteral("1 mm/s"));
        QCOMPARE(format::metresPerUnit(), 0.001);
    }

    void inchesApplyEverywhereOnceSelected() {
        applyNotation(*qApp, {LengthUnit::Inches, RotationNotation::RollPitchYaw});
        QCOMPARE(format::length(0.254), QStringLiteral("10.000 in"));
        QCOMPARE(format::shortLength(0.00005), QStringLiteral("0.0020 in"));
        QCOMPARE(format::shortLength(0.001), QStringLiteral("0.039 in"));
        QCOMPARE(format::shortLength(0.010), QStringLiteral("0.39 in"));
        QCOMPARE(format::speed(0.25), QStringLiteral("9.84 in/s"));
        QCOMPARE(format::speed(0.001), QStringLiteral("0.039 in/s"));
        QCOMPARE(format::speedUnit(), QStringLiteral("in/s"));
        QCOMPARE(format::shift({0.0254, 0, -0.0508}), QStringLiteral("ΔX +1.000 ΔY 0.000 ΔZ −2.000 in"));
        QCOMPARE(format::difference(0.0254, 0), QStringLiteral("1.00 in, 0.0°"));
        QCOMPARE(format::metresPerUnit(), 0.0254);
    }

    void aPoseShowsItsUnitsOnce() {
        const Pose pose(0.12, 0.08, 0.15, 0, 0, 1.5707963267948966);
        QCOMPARE(format::pose(pose),
                 QStringLiteral("X 120.00 Y 80.00 Z 150.00 mm RX 0.00 RY 0.00 RZ 90.00°"));
        applyNotation(*qApp, {LengthUnit::Millimetres, RotationNotation::RotationVector});
        QCOMPARE(format::pose(pose),
                 QStringLiteral("X 120.00 Y 80.00 Z 150.00 mm RX 0.0000 RY 0.0000 RZ 1.5708"));
    }

    void valueAcceptsEitherDecimalSignAndIgnoresTheWheel() {
        DecimalSpinBox box;
        box.setRange(-1000, 1000);
        box.setDecimals(2);
        box.setSuffix(QStringLiteral(" mm"));
        box.show();
        QVERIFY(QTest::qWaitForWindowActive(&box));
        int reported = 0;
        connect(&box, &DecimalSpinBox::valueChanged, &box, [&](double) { ++reported; });
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, "-12,5");
        QCOMPARE(reported, 0);  // the value is unchanged until editing is finished
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(box.value(), -12.5);
        QCOMPARE(box.text(), QStringLiteral("−12.50 mm"));
        // Spreadsheets and scripts use a hyphen as the minus sign. The box accepts both characters.
        box.selectAll();
        QTest::keyClick(&box, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("-12.50"));
        turnWheel(box);
        QCOMPARE(box.value(), -12.5);
        QCOMPARE(reported, 1);
    }

    void theWheelNeverChangesASelection() {
        ChoiceBox box;
        box.addItems({"Base", "tray", "table"});
        box.show();
        QVERIFY(QTest::qWaitForWindowActive(&box));
        box.setFocus();
        turnWheel(box);
        QCOMPARE(box.currentIndex(), 0);
    }

    void accessibleNamesFollowTheButtonText() {
        SegmentedControl control({"1", "10 mm"});
        control.setNames("step", "Step");
        QCOMPARE(control.segment(1)->accessibleName(), QStringLiteral("Step: 10 mm"));
        control.setText(1, "0.39 in");
        QCOMPARE(control.segment(1)->accessibleName(), QStringLiteral("Step: 0.39 in"));
    }
};

QTEST_MAIN(TestNotation)
#include "tst_notation.moc"
