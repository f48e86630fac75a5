// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawn curve never shows values that its data do not contain. Tested with random recordings, windows,
// zooms and pens.
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "widgets/plots/curve.h"
#include "widgets/plots/curve_raster.h"

using namespace tiller;

namespace {

constexpr int kHeight = 150;

struct Drawn {
    std::vector<std::unique_ptr<Curve>> curves;
    ColumnGrid grid;
    QImage image;

    Drawn(const SeriesBuffer& history, double t0, double span, int columns, double low, double high,
          const QPen& pen, Curve::Missing missing = Curve::Missing::Bridged) {
        curves.push_back(std::make_unique<Curve>(0, missing));
        curves[0]->setPen(pen);
        CurveRaster sheet(curves, nullptr);
        const double width = span / columns;
        const double start = std::round(t0 / width) * width;
        history.cut(start, width, columns, grid);
        curves[0]->sample(history, 0, grid);
        sheet.setView(QRectF(0, 0, columns, kHeight), start, start + span, low, high);
        image = QImage(columns, kHeight, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::white);
        QPainter painter(&image);
        sheet.paint(&painter, nullptr, nullptr);
    }
    /// The first and last painted row of a column; empty if nothing is painted.
    std::optional<std::pair<int, int>> rowsOf(int column) const {
        std::optional<std::pair<int, int>> rows;
        for (int y = 0; y < image.height(); ++y) {
            if (image.pixel(column, y) != qRgb(255, 255, 255)) {
                rows = {rows ? rows->first : y, y};
            }
        }
        return rows;
    }
};

/// Minimum and maximum of each column: its samples, and the lines to the neighbouring samples up to the
/// middle between the columns.
std::vector<MinMax> boundsOf(const SeriesBuffer& history, const ColumnGrid& grid) {
    const auto columns = static_cast<std::size_t>(grid.columns());
    std::vector<MinMax> own(columns);
    for (std::size_t i = 0; i < columns; ++i) {
        for (std::int64_t k = grid.edges[i]; k < grid.edges[i + 1]; ++k) {
            own[i].add(history.value(0, k));
        }
    }
    std::vector<MinMax> bounds = own;
    // Columns with many samples may begin at a summary, up to a third of their width earlier.
    const bool isWide = grid.edges.back() - grid.edges.front() > 3 * SeriesColumn::kSummary * grid.columns();
    // Line between two samples. Samples without a value are skipped.
    std::int64_t before = -1;
    for (std::int64_t k = history.first(); k < history.end(); ++k) {
        if (std::isnan(history.value(0, k))) {
            continue;
        }
        const double a = before < 0 ? 0 : (history.time(before) - grid.start) / grid.width;
        const double b = (history.time(k) - grid.start) / grid.width;
        for (double left = std::max(0.0, std::floor(a));
             before >= 0 && left <= b && left < static_cast<double>(columns); left += 1) {
            for (const double at : {std::max(a, left), std::min(b, left + 1)}) {
                const double share = std::clamp((at - a) / (b - a), 0.0, 1.0);
                const double from = history.value(0, before);
                bounds[static_cast<std::size_t>(left)].add(from + (history.value(0, k) - from) * share);
            }
        }
        before = k;
    }
    for (std::size_t i = 0; i < columns; ++i) {
        // The middle of the step between two columns.
        for (const std::size_t other : {i - 1, i + 1}) {
            if (other < columns && isWide) {
                bounds[i].add(own[other]);
            } else if (other < columns && !own[i].isEmpty() && !own[other].isEmpty()) {
                const double bottom = std::max(own[i].min, own[other].min);
                const double top = std::min(own[i].max, own[other].max);
                if (bottom > top) {
                    bounds[i].add((bottom + top) / 2);
                }
            }
        }
    }
    return bounds;
}

}  // namespace

class TestCurveBounds : public QObject {
    Q_OBJECT

private Q_SLOTS:
    // A step of 250 N and a spike, zoomed out and in.
    void anEdgeIsNotDrawnBeyondItsEnds() {
        SeriesBuffer history(1);
        std::array<float, 1> row{};
        for (int i = 0; i < 50'000; ++i) {
            row[0] = i < 25'000 ? 0.0F : 250.0F;
            history.append(i * 0.002, row);
        }
        for (const double span : {100.0, 20.0, 2.0, 0.4, 0.1, 0.02}) {
            const Drawn drawn(history, 50 - span / 2, span, 300, -100, 400, QPen(Qt::red, 2));
            const double perUnit = kHeight / 500.0;
            for (int x = 0; x < 300; ++x) {
                const auto rows = drawn.rowsOf(x);
                QVERIFY(rows);
                QVERIFY2(rows->first >= std::floor((400 - 250) * perUnit - 2) &&
                             rows->second <= std::ceil((400 - 0) * perUnit + 2),
                         qPrintable(QStringLiteral("%1 s, column %2: drawn from %3 N to %4 N")
                                        .arg(span)
                                        .arg(x)
                                        .arg(400 - (rows->second + 1) / perUnit)
                                        .arg(400 - rows->first / perUnit)));
            }
        }
    }

    // A computed signal such as 1/x becomes huge, or infinite as a float.
    void hugeAndInfiniteValuesAreDrawnWithinTheImage() {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        for (const float huge : {1e17F, 3e38F, kInfinity, -kInfinity}) {
            SeriesBuffer history(1);
            std::array<float, 1> row{};
            for (int i = 0; i < 1000; ++i) {
                row[0] = i % 100 == 50 ? huge : i % 100 == 51 ? -huge : static_cast<float>(i % 7);
                history.append(i * 0.002, row);
            }
            for (const double high : {10.0, 1e17, 1e38}) {
                for (const double span : {2.0, 0.1}) {
                    const Drawn drawn(history, 0.05, span, 300, -high, high, QPen(Qt::red, 2));
                    QVERIFY(drawn.rowsOf(0));
                }
            }
        }
    }

    // Otherwise, an infinite value of one curve hides all curves of the axis.
    void theRangeHasNoInfiniteValues() {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        SeriesBuffer history(1);
        std::array<float, 1> row{};
        for (int i = 0; i < 1000; ++i) {
            row[0] = i % 100 == 50 ? kInfinity : i % 100 == 51 ? -kInfinity : static_cast<float>(i % 7);
            history.append(i * 0.002, row);
        }
        for (const double span : {2.0, 0.5}) {  // several samples per column, and one at most
            const Drawn drawn(history, 0, span, 300, -10, 10, QPen(Qt::red, 2));
            QCOMPARE(drawn.curves[0]->range(), (MinMax{0, 6}));
        }
    }

    // The square root of a negative value is undefined, and a line there would show values that do not exist.
    void undefinedValuesInterruptTheCurve_data() {
        QTest::addColumn<double>("span");
        QTest::addColumn<int>("every");
        for (const double span : {4.0, 40.0}) {
            for (const int every : {1, 20}) {
                QTest::addRow("%g s, every %d", span, every) << span << every;
            }
        }
    }
    void undefinedValuesInterruptTheCurve() {
        QFETCH(double, span);
        QFETCH(int, every);
        SeriesBuffer history(1);
        std::array<float, 1> row{};
        const int samples = static_cast<int>(span / 0.002);
        for (int i = 0; i < samples; ++i) {
            const bool isDefined = i < samples / 4 || i >= samples / 2;
            row[0] = isDefined && i % every == 0 ? 5.0F : std::numeric_limits<float>::quiet_NaN();
            history.append(i * 0.002, row);
        }
        const QPen pen(Qt::red, 2);
        const Drawn derived(history, 0, span, 400, 0, 10, pen, Curve::Missing::Undefined);
        const Drawn field(history, 0, span, 400, 0, 10, pen);
        for (const int x : {10, 50, 90, 210, 300, 390}) {
            QVERIFY2(derived.rowsOf(x) && field.rowsOf(x), qPrintable(QString::number(x)));
        }
        for (const int x : {110, 150, 190}) {
            QVERIFY2(!derived.rowsOf(x), qPrintable(QString::number(x)));
            QVERIFY2(field.rowsOf(x), qPrintable(QString::number(x)));
        }
    }

    void everyColumnIsBetweenItsMinimumAndMaximum() {
        std::mt19937 random(35);
        std::uniform_real_distribution<double> share(0, 1);
        for (int run = 0; run < 150; ++run) {
            SeriesBuffer history(1);
            std::array<float, 1> row{};
            const int samples = 50 + static_cast<int>(random() % 20'000);
            const unsigned kind = random() % 4;
            double level = 0;
            for (int i = 0; i < samples; ++i) {
                level = random() % 200 == 0 ? share(random) * 200 - 100 : level;
                const double noise = kind == 1 ? share(random) * 20 : 0;
                const double spike = kind == 2 && random() % 300 == 0 ? 150 : 0;
                row[0] = static_cast<float>(kind == 3 ? 100 * std::sin(i * 0.05) : level + noise + spike);
                row[0] = random() % 500 == 0 ? std::numeric_limits<float>::quiet_NaN() : row[0];
                history.append(10 + i * 0.002, row);
            }
            const double length = samples * 0.002;
            const double span = length * std::pow(10, -2 * share(random));
            const double t0 = 10 + share(random) * (length - span);
            QPen pen(Qt::red, 1 + 2 * share(random));
            if (random() % 4 == 0) {
                pen.setDashPattern({6, 3});
            }
            const int columns = 100 + static_cast<int>(random() % 300);
            const double low = -50 - 100 * share(random);
            const double high = 50 + 200 * share(random);
            const Drawn drawn(history, t0, span, columns, low, high, pen);
            const std::vector<MinMax> bounds = boundsOf(history, drawn.grid);
            const double perUnit = kHeight / (high - low);
            for (int x = 0; x < columns; ++x) {
                const auto rows = drawn.rowsOf(x);
                const MinMax& bound = bounds[static_cast<std::size_t>(x)];
                if (!rows || bound.isEmpty()) {
                    continue;
                }
                const double top = std::floor((high - bound.max) * perUnit - pen.widthF());
                const double bottom = std::ceil((high - bound.min) * perUnit + pen.widthF());
                QVERIFY2((rows->first >= top || rows->first == 0) &&
                             (rows->second <= bottom || rows->second == kHeight - 1),
                         qPrintable(QStringLiteral("run %1, column %2 of %3: rows %4 to %5, allowed %6 to "
                                                   "%7; curve %8 to %9, bound %10 to %11, envelope %12")
                                        .arg(run)
                                        .arg(x)
                                        .arg(columns)
                                        .arg(rows->first)
                                        .arg(rows->second)
                                        .arg(top)
                                        .arg(bottom)
                                        .arg(drawn.curves[0]->columns()[static_cast<std::size_t>(x)].low)
                                        .arg(drawn.curves[0]->columns()[static_cast<std::size_t>(x)].high)
                                        .arg(bound.min)
                                        .arg(bound.max)
                                        .arg(drawn.grid.edges.back() - drawn.grid.edges.front() > columns)));
            }
            // The same check for vector formats.
            const QPainterPath path = drawn.curves[0]->path(QRectF(0, 0, columns, kHeight), 0, 1, low, high);
            MinMax all;
            for (const MinMax& bound : bounds) {
                all.add(bound);
            }
            for (int i = 0; i < path.elementCount() && !all.isEmpty(); ++i) {
                const double value = low + (kHeight - path.elementAt(i).y) / perUnit;
                QVERIFY(value >= all.min - 1e-6 && value <= all.max + 1e-6);
            }
        }
    }
};

QTEST_MAIN(TestCurveBounds)
#include "tst_curve_bounds.moc"
