// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows every mode of every enumeration on one sheet, as in the header bar, and checks that people with
// red-green colour blindness can distinguish them. The sheet is saved next to the test program or in
// TILLER_SCREENSHOTS.

#include <QApplication>
#include <QDir>
#include <QPainter>
#include <QSet>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/common/theme.h"
#include "widgets/status/mode_look.h"

using namespace tiller;

namespace {

enum class Vision { Normal, Protanopia, Deuteranopia };
constexpr std::array kVisions = {Vision::Normal, Vision::Protanopia, Vision::Deuteranopia};

double toLinear(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double fromLinear(double c) {
    const double v = std::clamp(c, 0.0, 1.0);
    return v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// The colour as seen by an eye without red or green receptors. Source: Machado, Oliveira, Fernandes 2009,
/// full severity, on linear RGB.
QColor seenBy(const QColor& colour, Vision vision) {
    using Matrix = std::array<std::array<double, 3>, 3>;
    static constexpr Matrix kProtanopia = {
        {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
    static constexpr Matrix kDeuteranopia = {
        {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
    if (vision == Vision::Normal) {
        return colour;
    }
    const Matrix& m = vision == Vision::Protanopia ? kProtanopia : kDeuteranopia;
    const std::array<double, 3> rgb = {toLinear(colour.redF()), toLinear(colour.greenF()),
                                       toLinear(colour.blueF())};
    std::array<double, 3> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = fromLinear(m[i][0] * rgb[0] + m[i][1] * rgb[1] + m[i][2] * rgb[2]);
    }
    return QColor::fromRgbF(static_cast<float>(out[0]), static_cast<float>(out[1]),
                            static_cast<float>(out[2]));
}

/// Perceived colour difference (CIE 1976): 2 is just noticeable, 20 is a different colour.
double distance(const QColor& a, const QColor& b) {
    const auto lab = [](const QColor& c) {
        const double r = toLinear(c.redF());
        const double g = toLinear(c.greenF());
        const double l = toLinear(c.blueF());
        const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
        const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * l) / 0.95047);
        const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * l);
        const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * l) / 1.08883);
        return std::array<double, 3>{116 * y - 16, 500 * (x - y), 200 * (y - z)};
    };
    const auto p = lab(a);
    const auto q = lab(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

struct Cell {
    QString group;
    QString name;
    ModeLook look;
    QImage picture;
    QImage icon;  ///< the same image without its text
};

QImage pictureOf(const QString& group, const ModeLook& look, const QString& words) {
    StateChip chip(group);
    chip.setState(words, look.shape, look.emphasis, look.advice);
    chip.setMark(look.mark);
    chip.resize(260, StateChip::kHeight);
    return chip.grab().toImage().convertToFormat(QImage::Format_RGB32);
}

QVector<Cell> allCells() {
    QVector<Cell> cells;
    const auto add = [&cells](const QString& group, const QString& name, const ModeLook& look) {
        cells.append({group, name, look, pictureOf(group, look, look.text), pictureOf({}, look, {})});
    };
    for (const RobotMode mode : robotModes()) {
        add(QStringLiteral("ROBOT MODE"), robotModeName(mode), robotModeLook(mode, false));
    }
    add(QStringLiteral("ROBOT MODE"), QStringLiteral("moving"), robotModeLook(RobotMode::Running, true));
    for (const SafetyStatus status : safetyStatuses()) {
        add(QStringLiteral("SAFETY"), safetyModeName(status), safetyModeLook(status));
    }
    for (const RuntimeState state : runtimeStates()) {
        add(QStringLiteral("PROGRAM"), runtimeStateName(state), runtimeLook(state));
    }
    return cells;
}

/// Area of the chip that contains the shape and the mark.
constexpr QRect kIcon(10, 22, 34, 26);

/// Number of pixels of the icon whose colour is clearly different for this eye.
int iconDifference(const QImage& a, const QImage& b, Vision vision) {
    int different = 0;
    for (int y = kIcon.top(); y <= kIcon.bottom(); ++y) {
        for (int x = kIcon.left(); x <= kIcon.right(); ++x) {
            const QColor first = seenBy(a.pixelColor(x, y), vision);
            const QColor second = seenBy(b.pixelColor(x, y), vision);
            different += distance(first, second) > 20 ? 1 : 0;
        }
    }
    return different;
}

void saveSheet(const QVector<Cell>& cells, const QString& theme) {
    constexpr int kWide = 270;
    constexpr int kHigh = 76;
    constexpr int kColumns = 4;
    const int rows = (static_cast<int>(cells.size()) + kColumns - 1) / kColumns;
    QImage sheet(kColumns * kWide + 10, (rows * kHigh + 30) * static_cast<int>(kVisions.size()),
                 QImage::Format_RGB32);
    sheet.fill(Theme::current().background);
    QPainter painter(&sheet);
    int top = 0;
    for (const Vision vision : kVisions) {
        painter.setPen(Theme::current().text);
        painter.setFont(textFont(15, QFont::Bold));
        painter.drawText(10, top + 22,
                         vision == Vision::Normal       ? QStringLiteral("Normal vision")
                         : vision == Vision::Protanopia ? QStringLiteral("Protanopia")
                                                        : QStringLiteral("Deuteranopia"));
        for (int i = 0; i < cells.size(); ++i) {
            QImage seen = cells[i].picture;
            for (int y = 0; y < seen.height(); ++y) {
                for (int x = 0; x < seen.width(); ++x) {
                    seen.setPixelColor(x, y, seenBy(seen.pixelColor(x, y), vision));
                }
            }
            const QPoint at(10 + i % kColumns * kWide, top + 30 + i / kColumns * kHigh);
            painter.drawImage(at, seen);
            painter.setFont(textFont(10));
            painter.setPen(Theme::current().secondary);
            painter.drawText(at + QPoint(2, 64), cells[i].name);
        }
        top += rows * kHigh + 30;
    }
    painter.end();
    QString folder = qEnvironmentVariable("TILLER_SCREENSHOTS");
    if (folder.isEmpty()) {
        folder = QCoreApplication::applicationDirPath();
    }
    QVERIFY(QDir().mkpath(folder));
    QVERIFY(sheet.save(folder + QStringLiteral("/contact-sheet-") + theme + QStringLiteral(".png")));
}

}  // namespace

class TestContactSheet : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void colourMeasureDistinguishesColours() {
        // A red and a green of the same lightness. They are different for most people, but identical without
        // green receptors.
        const QColor red(196, 80, 80);
        const QColor green(122, 117, 65);
        QVERIFY(distance(red, green) > 40);
        QVERIFY(distance(seenBy(red, Vision::Deuteranopia), seenBy(green, Vision::Deuteranopia)) <
                distance(red, green) / 2);
        const QColor grey(120, 120, 120);
        QVERIFY(distance(seenBy(grey, Vision::Protanopia), grey) < 3);
        // Two modes with the same shape and no mark cannot be distinguished by their icons.
        const ModeLook a{QStringLiteral("One"), StateChip::Shape::Octagon, StateChip::Emphasis::Alarm, {}};
        const ModeLook b{QStringLiteral("Two"), StateChip::Shape::Octagon, StateChip::Emphasis::Alarm, {}};
        QCOMPARE(iconDifference(pictureOf({}, a, {}), pictureOf({}, b, {}), Vision::Normal), 0);
    }

    void allModesAreDistinguishable_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void allModesAreDistinguishable() {
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? Theme::dark() : Theme::light());
        const QVector<Cell> cells = allCells();
        QCOMPARE(cells.size(),
                 qsizetype(robotModes().size() + 1 + safetyStatuses().size() + runtimeStates().size()));
        saveSheet(cells, dark ? QStringLiteral("dark") : QStringLiteral("light"));
        QStringList alike;
        for (const Vision vision : kVisions) {
            for (int i = 0; i < cells.size(); ++i) {
                for (int j = i + 1; j < cells.size(); ++j) {
                    if (cells[i].group != cells[j].group) {
                        continue;  // the caption above the icon distinguishes them
                    }
                    if (cells[i].look.text == cells[j].look.text ||
                        cells[i].look.advice == cells[j].look.advice) {
                        alike << cells[i].name + " and " + cells[j].name + ": same words";
                    }
                    if (const int n = iconDifference(cells[i].icon, cells[j].icon, vision); n < 4) {
                        alike << QStringLiteral("%1 and %2: icons differ in %3 pixels (vision %4)")
                                     .arg(cells[i].name, cells[j].name)
                                     .arg(n)
                                     .arg(static_cast<int>(vision));
                    }
                }
            }
        }
        QVERIFY2(alike.isEmpty(), qPrintable(alike.join('\n')));
    }

    void everyIconAndWordIsReadableWithoutRedOrGreen_data() { allModesAreDistinguishable_data(); }
    void everyIconAndWordIsReadableWithoutRedOrGreen() {
        QFETCH(bool, dark);
        applyTheme(*qApp, dark ? Theme::dark() : Theme::light());
        QStringList faint;
        for (const Cell& cell : allCells()) {
            const QColor fill = cell.picture.pixelColor(cell.picture.width() - 20, StateChip::kHeight - 10);
            for (const Vision vision : kVisions) {
                double best = 0;
                for (int y = kIcon.top(); y <= kIcon.bottom(); ++y) {
                    for (int x = kIcon.left(); x < kIcon.left() + 18; ++x) {
                        best = std::max(best, contrastRatio(seenBy(cell.picture.pixelColor(x, y), vision),
                                                            seenBy(fill, vision)));
                    }
                }
                if (best < 4.5) {
                    faint << QStringLiteral("%1: contrast %2").arg(cell.name).arg(best);
                }
            }
        }
        QVERIFY2(faint.isEmpty(), qPrintable(faint.join('\n')));
    }

    void modesThatNeedActionDifferInColourToo() {
        // Colour is never the only difference, but where it is used, it must be visible to everyone.
        for (const Theme& theme : {Theme::light(), Theme::dark()}) {
            for (const QColor& fill : {theme.stop, theme.operatorNeeded, theme.moving}) {
                for (const Vision vision : kVisions) {
                    QVERIFY(distance(seenBy(fill, vision), seenBy(theme.panel, vision)) > 20);
                }
            }
        }
    }
};

QTEST_MAIN(TestContactSheet)
#include "tst_contact_sheet.moc"
