// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCheckBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QStyleOptionButton>
#include <QTest>
#include <QToolButton>

#include "widgets/common/density.h"
#include "widgets/common/icons.h"
#include "widgets/common/style_sheet.h"
#include "widgets/common/theme.h"

using namespace tiller;

class TestTheme : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void untickedBoxesAreVisible_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void untickedBoxesAreVisible() {
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? Theme::dark() : Theme::light());
        QCheckBox box(QStringLiteral("ticked"));
        box.ensurePolished();
        box.resize(box.sizeHint());
        QStyleOptionButton option;
        option.initFrom(&box);
        const QRect tick = box.style()->subElementRect(QStyle::SE_CheckBoxIndicator, &option, &box);
        const QImage image = box.grab().toImage();
        const QColor ground = image.pixelColor(box.width() - 1, 0);
        double best = 0;
        for (int x = tick.left(); x <= tick.right(); ++x) {
            best = std::max(best, contrastRatio(image.pixelColor(x, tick.center().y()), ground));
        }
        QVERIFY2(best >= 3, qPrintable(QString::number(best)));
        applyTheme(*qApp, Theme::light());
    }

    void contrastOfBlackOnWhiteIsTwentyOne() {
        QVERIFY(std::abs(contrastRatio(Qt::black, Qt::white) - 21.0) < 0.01);
        QVERIFY(std::abs(contrastRatio(Qt::red, Qt::red) - 1.0) < 0.001);
    }

    void textRolesAreReadable_data() {
        QTest::addColumn<QColor>("ink");
        QTest::addColumn<QColor>("ground");
        QTest::addColumn<double>("least");
        for (const Theme* t : {&Theme::light(), &Theme::dark()}) {
            const auto row = [t](const char* name, const QColor& ink, const QColor& ground, double least) {
                const QByteArray title = (t->isDark() ? "dark " : "light ") + QByteArray(name);
                QTest::newRow(title.constData()) << ink << ground << least;
            };
            row("text on background", t->text, t->background, 5);
            row("text on panel", t->text, t->panel, 5);
            row("text on raised", t->text, t->raised, 5);
            row("text on hover", t->text, t->hover, 5);
            row("text on moving tint", t->text, t->movingTint, 5);
            row("secondary on background", t->secondary, t->background, 4.5);
            row("secondary on panel", t->secondary, t->panel, 4.5);
            row("secondary on raised", t->secondary, t->raised, 4.5);
            row("disabled on panel", t->disabledText, t->panel, 4.5);
            row("disabled on raised", t->disabledText, t->raised, 4.5);
            row("chosen segment", t->inverseText, t->inverse, 5);
            row("moving chip", t->movingText, t->moving, 5);
            row("warning line", t->warning, t->warningBackground, 4.5);
            row("warning on panel", t->warning, t->panel, 4.5);
            row("alarm on panel", t->alarm, t->panel, 5);
            row("alarm on raised", t->alarm, t->raised, 5);
            row("alarm on its ground", t->alarm, t->alarmBackground, 4.5);
            row("stop key", t->stopText, t->stop, 5);
            row("operator needed", t->operatorNeededText, t->operatorNeeded, 5);
            row("simulation", t->simulationText, t->simulation, 4.5);
            row("simulation stripe", t->simulationText, t->simulationStripe, 4.5);
            row("recording", t->recording, t->raised, 5);
            for (int axis = 0; axis < 3; ++axis) {
                row(("axis letter " + QByteArray::number(axis)).constData(),
                    t->axisTexts.at(static_cast<std::size_t>(axis)), t->panel, 4.5);
                row(("axis bar " + QByteArray::number(axis)).constData(), t->axis(axis), t->raised, 3);
            }
        }
    }

    void textRolesAreReadable() {
        QFETCH(QColor, ink);
        QFETCH(QColor, ground);
        QFETCH(double, least);
        const double ratio = contrastRatio(ink, ground);
        QVERIFY2(
            ratio >= least,
            qPrintable(
                QStringLiteral("%1 on %2: %3 < %4").arg(ink.name(), ground.name()).arg(ratio).arg(least)));
    }

    void everyRoleOfTheStyleSheetIsFilledIn() {
        for (const Theme* t : {&Theme::light(), &Theme::dark()}) {
            const QString sheet = styleSheet(*t);
            QVERIFY(!sheet.contains(QLatin1Char('@')));
            QVERIFY(sheet.contains(t->warning.name()));
        }
        QVERIFY(styleSheet(Theme::light()) != styleSheet(Theme::dark()));
    }

    void applyingAThemeReachesPaletteAndWidgets() {
        QPushButton button;
        applyTheme(*qApp, Theme::dark());
        QCOMPARE(Theme::current().scheme, ColorScheme::Dark);
        button.ensurePolished();
        QCOMPARE(qApp->palette().color(QPalette::Window), Theme::dark().background);
        applyTheme(*qApp, Theme::light());
        QCOMPARE(Theme::current().scheme, ColorScheme::Light);
        QCOMPARE(qApp->palette().color(QPalette::Window), Theme::light().background);
    }

    void digitsOfBothFontsHaveTheSameWidth() {
        for (const QFont& font : {textFont(15), numberFont(15)}) {
            const QFontMetrics metrics(font);
            for (char digit = '1'; digit <= '9'; ++digit) {
                QCOMPARE(metrics.horizontalAdvance(QLatin1Char(digit)),
                         metrics.horizontalAdvance(QLatin1Char('0')));
            }
        }
    }

    void theClearButtonIsInsideItsField() {
        const Density before = currentDensity();
        applyTheme(*qApp, Theme::light());
        for (const Density density : {Density::Compact, Density::Touch}) {
            applyDensity(*qApp, density);
            QLineEdit field;
            field.setClearButtonEnabled(true);
            field.show();
            field.setText(QStringLiteral("words"));
            const auto* clear = field.findChild<QToolButton*>();
            QVERIFY(clear != nullptr);
            const QRect place = clear->geometry();
            QVERIFY2(field.rect().contains(place), qPrintable(QStringLiteral("%1 px high at %2, field %3 px")
                                                                  .arg(place.height())
                                                                  .arg(place.top())
                                                                  .arg(field.height())));
            QVERIFY(std::abs(place.center().y() - field.rect().center().y()) <= 1);
        }
        applyDensity(*qApp, before);
    }

    void aTickInAListIsVisible() {
        for (const Theme* theme : {&Theme::light(), &Theme::dark()}) {
            applyTheme(*qApp, *theme);
            QListWidget list;
            for (const Qt::CheckState state : {Qt::Unchecked, Qt::Checked}) {
                auto* item = new QListWidgetItem(&list);
                item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable);
                item->setCheckState(state);
            }
            list.resize(300, 200);
            list.show();
            const QImage image = list.viewport()->grab().toImage();
            const auto contrastIn = [&](int row) {
                QStyleOptionViewItem option;
                option.initFrom(&list);
                option.rect = list.visualItemRect(list.item(row));
                option.features = QStyleOptionViewItem::HasCheckIndicator;
                option.index = list.model()->index(row, 0);
                const QRect box =
                    list.style()->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, &list);
                // The inner part, without the frame.
                const QRect inner = box.adjusted(3, 3, -3, -3);
                double most = 1;
                for (int y = inner.top(); y <= inner.bottom(); ++y) {
                    for (int x = inner.left(); x <= inner.right(); ++x) {
                        most = std::max(
                            most, contrastRatio(image.pixelColor(x, y), image.pixelColor(inner.topLeft())));
                    }
                }
                return most;
            };
            QVERIFY2(contrastIn(0) < 1.1, qPrintable(QString::number(contrastIn(0))));
            QVERIFY2(contrastIn(1) >= 4.5, qPrintable(QString::number(contrastIn(1))));
        }
    }

    void iconsTakeTheColourOfTheTheme() {
        const QIcon icon = themedIcon(QStringLiteral("stop"), QColor(0x12, 0x34, 0x56));
        QVERIFY(!icon.isNull());
        const QImage image = icon.pixmap(24, 24).toImage();
        QCOMPARE(image.pixelColor(image.width() / 2, image.height() / 2).rgb(), qRgb(0x12, 0x34, 0x56));
        QVERIFY(themedIcon(QStringLiteral("no such icon")).isNull());
        QVERIFY(!applicationIcon().isNull());
    }
};

QTEST_MAIN(TestTheme)
#include "tst_theme.moc"
