// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "robot/station/history/spectrum.h"

using namespace tiller;

namespace {

constexpr double kPeriod = 0.002;

std::vector<double> wave(std::size_t count, double hertz, double amplitude, double offset) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        values[i] =
            offset + amplitude * std::sin(2 * std::numbers::pi * hertz * static_cast<double>(i) * kPeriod);
    }
    return values;
}

}  // namespace

class TestSpectrum : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aSineHasItsFrequencyAndAmplitude_data() {
        QTest::addColumn<int>("count");
        QTest::newRow("one segment") << 1024;
        QTest::newRow("no power of two") << 3000;
        QTest::newRow("many segments") << 100'000;
    }
    void aSineHasItsFrequencyAndAmplitude() {
        QFETCH(int, count);
        // The frequency is exactly at a line of the transform, for every length.
        const double hertz = 500.0 / 16;
        const auto spectrum = spectrumOf(wave(static_cast<std::size_t>(count), hertz, 3, -7), kPeriod);
        QVERIFY(spectrum.ok());
        QCOMPARE(spectrum->resolution, 500.0 / spectrum->segment);
        const auto& lines = spectrum->amplitude;
        QCOMPARE(lines.size(), static_cast<std::size_t>(spectrum->segment / 2 + 1));
        const auto top = std::max_element(lines.begin() + 1, lines.end());
        QCOMPARE(static_cast<double>(top - lines.begin()) * spectrum->resolution, hertz);
        QVERIFY(std::abs(*top - 3) < 0.01);
        QVERIFY(std::abs(lines.front() - 7) < 0.1);
        // Outside its main lobe, a Hann window has almost no amplitude.
        QVERIFY(*(top + 4) < 0.01);
    }
    void impossibleRequestsAreRefusedWithAReason() {
        QVERIFY(spectrumOf(wave(15, 10, 1, 0), kPeriod).error().controllerMessage.contains("16"));
        QVERIFY(!spectrumOf(wave(100, 10, 1, 0), 0).ok());
        auto hole = wave(100, 10, 1, 0);
        hole[40] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(spectrumOf(hole, kPeriod).error().controllerMessage.contains("gap"));
    }
};

QTEST_GUILESS_MAIN(TestSpectrum)
#include "tst_spectrum.moc"
